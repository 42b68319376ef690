// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/slip_in_situ.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace fissura::input {

namespace {

struct Traction {
  double normal;  ///< tension positive [Pa]
  double shear;   ///< [Pa]
};

Traction traction_on(const std::array<double, 3>& stress, const Point& a, const Point& b) {
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  const double nx = -(b[1] - a[1]) / length, ny = (b[0] - a[0]) / length;
  const double tx = stress[0] * nx + stress[2] * ny, ty = stress[2] * nx + stress[1] * ny;
  return {tx * nx + ty * ny, ty * nx - tx * ny};
}

struct Overload {
  double shear, strength;  ///< [Pa]
};

std::optional<Overload> overload(const InSitu& in_situ, const FractureLine& line) {
  for (std::size_t j = 1; j < line.points.size(); ++j) {
    const Point &a = line.points[j - 1], &b = line.points[j];
    const Traction traction =
        traction_on(in_plane_stress(in_situ, {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}), a, b);
    const double strength =
        line.cohesion + line.tensile_strength - line.friction_coefficient * traction.normal;
    if (std::abs(traction.shear) > strength) return Overload{std::abs(traction.shear), strength};
  }
  return std::nullopt;
}

}  // namespace

std::array<double, 3> in_plane_stress(const InSitu& in_situ, const Point& point) {
  std::array<double, 3> stress{};
  for (std::size_t i = 0; i < stress.size(); ++i)
    stress[i] = in_situ.stress[i] + in_situ.stress_gradient[i][0] * point[0] +
                in_situ.stress_gradient[i][1] * point[1];
  return stress;
}

void warn_of_slip_in_situ(const Case& value, const SourceValue& document, FaultList& warnings) {
  std::size_t slipping = 0, first = 0;
  Overload of_first{};
  for (std::size_t i = 0; i < value.fractures.size(); ++i) {
    const FractureLine& line = value.fractures[i];
    if (line.kind != FractureKind::natural) continue;
    const std::optional<Overload> found = overload(value.in_situ, line);
    if (!found) continue;
    if (slipping++ > 0) continue;
    first = i;
    of_first = *found;
  }
  if (slipping == 0) return;
  const FractureLine& line = value.fractures[first];
  const std::string key = line.set.empty() ? fmt::format("fracture[{}]", first) : "natural_fractures";
  const std::string others = slipping > 1 ? fmt::format(", and {} more", slipping - 1) : "";
  const std::string when =
      value.dynamics.equilibrate ? "it comes to rest before time 0" : "it moves from time 0";
  warnings.push_back(
      {position_of(document, key), key,
       fmt::format("natural fracture \"{}\" slipping under the in-situ stress: {:.6g} Pa of shear{}",
                   line.name, of_first.shear, others),
       fmt::format("at most its strength, {:.6g} Pa; {}", of_first.strength, when), ""});
}

}  // namespace fissura::input
