// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/case/check_case.hpp"

namespace fissura::input {

namespace {

class GrowthCheck {
 public:
  GrowthCheck(const Case& value, const SourceValue& document, FaultList& faults)
      : case_(value), document_(document), faults_(faults) {}

  void rules() const {
    const Growth& growth = case_.growth;
    if (growth.tip == TipRule::damage) rule("growth.tip", "\"damage\"");
    if (growth.nucleation) rule("growth.nucleation", "true");
  }

  void sizes() const {
    const MeshControls& mesh = case_.mesh;
    if (mesh.tip_size > mesh.fracture_size)
      refuse("mesh.tip_size", fmt::format("{} m", mesh.tip_size),
             fmt::format("at most mesh.fracture_size, {} m", mesh.fracture_size));
    if (mesh.tip_radius < mesh.tip_size)
      refuse("mesh.tip_radius", fmt::format("{} m", mesh.tip_radius),
             fmt::format("at least mesh.tip_size, {} m", mesh.tip_size));
  }

  void refinement(std::size_t index) const {
    const Refinement& part = case_.mesh.refinements[index];
    const std::string key = fmt::format("mesh.refinement[{}]", index);
    if (part.size > case_.mesh.far_size)
      refuse(key + ".size", fmt::format("{} m", part.size),
             fmt::format("at most mesh.far_size, {} m", case_.mesh.far_size));
    if (part.west >= part.east)
      refuse(key + ".east", fmt::format("{} m", part.east), fmt::format("east of west, {} m", part.west));
    if (part.south >= part.north)
      refuse(key + ".north", fmt::format("{} m", part.north),
             fmt::format("north of south, {} m", part.south));
    const double x = case_.domain.width / 2, y = case_.domain.height / 2;
    if (part.west >= x || part.east <= -x || part.south >= y || part.north <= -y)
      refuse(
          key,
          fmt::format("x from {} to {} m, y from {} to {} m", part.west, part.east, part.south, part.north),
          fmt::format("a rectangle that overlaps the domain, |x| < {} m and |y| < {} m", x, y));
  }

  /// F is a convex function of the stress, and that is linear in the place: F is greatest in a corner.
  void shear_failure() const {
    const BulkFailure& failure = case_.bulk_failure;
    if (!(failure.cohesion > 0)) return;
    const double sine = std::sin(failure.friction_angle), cosine = std::cos(failure.friction_angle);
    const double x = case_.domain.width / 2, y = case_.domain.height / 2;
    for (const Point& corner : {Point{-x, -y}, Point{x, -y}, Point{x, y}, Point{-x, y}}) {
      const auto [least, greatest] = extreme_principal_stresses(corner);
      const double shear = greatest - least;
      const double strength = 2 * failure.cohesion * cosine - (greatest + least) * sine;
      if (!(shear > strength)) continue;
      refuse("failure.cohesion",
             fmt::format("an in-situ difference of principal stresses of {:.6g} Pa at ({}, {}) m", shear,
                         corner[0], corner[1]),
             fmt::format(
                 "at most 2 c cos(phi) - (s_1 + s_3) sin(phi) = {:.6g} Pa: the rock would fail before the "
                 "run begins",
                 strength));
      return;
    }
  }

  void tension_corner() const {
    const BulkFailure& failure = case_.bulk_failure;
    const double apex = failure.cohesion / std::tan(failure.friction_angle);
    if (failure.cohesion > 0 && failure.friction_angle > 0 && apex <= case_.rock.tensile_strength)
      refuse(
          "failure.cohesion", fmt::format("{} Pa", failure.cohesion),
          fmt::format("more than rock.tensile_strength tan(friction_angle), {:.6g} Pa: the tensile strength "
                      "would lie beyond the apex of the surface",
                      case_.rock.tensile_strength * std::tan(failure.friction_angle)));
  }

 private:
  void rule(const std::string& key, const std::string& found) const {
    if (!case_.bulk_failure.active)
      refuse(key, found, "a table [failure] beside it: fractures begin here where the rock has failed");
    if (case_.growth.path != PathRule::free) refuse(key, found, "growth.path = \"free\" beside it");
  }

  [[nodiscard]] std::pair<double, double> extreme_principal_stresses(const Point& place) const {
    std::array<double, 4> stress = case_.in_situ.stress;
    for (std::size_t i = 0; i < stress.size(); ++i)
      stress[i] +=
          case_.in_situ.stress_gradient[i][0] * place[0] + case_.in_situ.stress_gradient[i][1] * place[1];
    const double mean = (stress[0] + stress[1]) / 2;
    const double radius = std::hypot((stress[0] - stress[1]) / 2, stress[2]);
    return {std::min(mean - radius, stress[3]), std::max(mean + radius, stress[3])};
  }

  void refuse(const std::string& key, const std::string& found, const std::string& expected) const {
    faults_.push_back({position_of(document_, key), key, found, expected, ""});
  }

  const Case& case_;
  const SourceValue& document_;
  FaultList& faults_;
};

}  // namespace

void check_growth(const Case& value, const SourceValue& document, FaultList& faults) {
  const GrowthCheck check(value, document, faults);
  check.rules();
  check.sizes();
  for (std::size_t i = 0; i < value.mesh.refinements.size(); ++i) check.refinement(i);
  check.shear_failure();
  check.tension_corner();
}

}  // namespace fissura::input
