// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/case/check_case.hpp"
#include "common/case/slip_in_situ.hpp"

namespace fissura::input {

namespace {

/// Part of the greatest term of the balance that rounding of the numbers in a case may leave.
constexpr double balance_tolerance = 1e-6;

bool holds(const Boundary& side, BoundaryKind normal_only_if) {
  return side.kind == BoundaryKind::fixed || side.kind == BoundaryKind::displacement ||
         side.kind == normal_only_if;
}

/// Whether a side keeps the body from moving along its own normal, or across it.
bool holds_normal(const Boundary& side) {
  return holds(side, BoundaryKind::roller);
}
bool holds_across(const Boundary& side) {
  return holds(side, BoundaryKind::fixed);
}

void check_support(const Case& value, const SourceValue& document, FaultList& faults) {
  const Boundaries& sides = value.boundary;
  const bool x = holds_normal(sides.west) || holds_normal(sides.east) || holds_across(sides.south) ||
                 holds_across(sides.north);
  const bool y = holds_normal(sides.south) || holds_normal(sides.north) || holds_across(sides.west) ||
                 holds_across(sides.east);
  const auto refuse = [&](const std::string& direction, const std::string& expected) {
    faults.push_back({position_of(document, "boundary"), "boundary",
                      "nothing that holds the body in " + direction, expected, ""});
  };
  if (!x) refuse("x", "a fixed or displacement side, or a roller at west or east");
  if (!y) refuse("y", "a fixed or displacement side, or a roller at south or north");
}

void check_equilibrium(const Case& value, const SourceValue& document, FaultList& faults) {
  const InSitu& in_situ = value.in_situ;
  const auto& [xx, yy, xy, zz] = in_situ.stress_gradient;
  const std::array<std::array<double, 4>, 2> terms{
      {{xx[0], xy[1], -value.rock.biot_coefficient * in_situ.pore_pressure_gradient[0],
        value.rock.density * in_situ.body_acceleration[0]},
       {xy[0], yy[1], -value.rock.biot_coefficient * in_situ.pore_pressure_gradient[1],
        value.rock.density * in_situ.body_acceleration[1]}}};
  for (std::size_t direction = 0; direction < terms.size(); ++direction) {
    double sum = 0, greatest = 0;
    for (const double term : terms[direction]) {
      sum += term;
      greatest = std::max(greatest, std::abs(term));
    }
    if (std::abs(sum) > balance_tolerance * greatest)
      faults.push_back(
          {position_of(document, "in_situ.gradient"), "in_situ.gradient",
           fmt::format("forces that do not balance in {}: {:.6g} Pa/m remain", direction == 0 ? "x" : "y",
                       sum),
           "div(stress) - biot_coefficient grad(pore_pressure) + density body_acceleration = 0 (tension "
           "positive)",
           ""});
  }
}

double greatest_principal(const std::array<double, 3>& stress) {
  return (stress[0] + stress[1]) / 2 + std::hypot((stress[0] - stress[1]) / 2, stress[2]);
}

/// The greatest principal stress is a convex function of the place: it is greatest in a corner.
void check_tensile_strength(const Case& value, const SourceValue& document, FaultList& faults) {
  const double x = value.domain.width / 2, y = value.domain.height / 2;
  for (const Point& corner : {Point{-x, -y}, Point{x, -y}, Point{x, y}, Point{-x, y}}) {
    const double tension = greatest_principal(in_plane_stress(value.in_situ, corner));
    if (!(tension > value.rock.tensile_strength)) continue;
    const bool everywhere_tensile = std::min({value.in_situ.stress[0], value.in_situ.stress[1]}) > 0;
    faults.push_back(
        {position_of(document, "in_situ.maximum_horizontal_stress"), "in_situ",
         fmt::format("an effective tension of {:.6g} Pa at ({}, {}) m", tension, corner[0], corner[1]),
         fmt::format("at most rock.tensile_strength, {} Pa{}", value.rock.tensile_strength,
                     everywhere_tensile ? "; is in_situ.sign the other one?" : ""),
         ""});
    return;
  }
}

}  // namespace

void check_in_situ(const Case& value, const SourceValue& document, FaultList& faults) {
  check_support(value, document, faults);
  check_equilibrium(value, document, faults);
  check_tensile_strength(value, document, faults);
}

}  // namespace fissura::input
