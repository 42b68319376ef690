// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/failure_map.hpp"

#include <algorithm>
#include <cmath>

#include "structure/dynamics/triangle.hpp"

namespace fissura::structure {

bool forms_from_failed_rock(const Case& run_case) {
  return run_case.bulk_failure.active &&
         (run_case.growth.tip == TipRule::damage || run_case.growth.nucleation);
}

FailureMap::FailureMap(const StructureModel& model, const Geometry& geometry, const StructureState& state) {
  const RockFailure law = rock_failure(model.run_case.rock, model.run_case.bulk_failure);
  for (const ElementDamage& record : damage_records(geometry.tiles, state.body.damage))
    lost_.emplace(record.element, lost_strength(law.tension, record.history));
}

double FailureMap::greatest_near(const Mesh& mesh, const std::vector<ElementIndex>& among,
                                 const Point& centre, double radius) const {
  double greatest = 0;
  for (const ElementIndex element : among) {
    const double share = lost(element);
    if (share <= greatest) continue;
    const Point at = centroid(mesh, element);
    if (std::hypot(at[0] - centre[0], at[1] - centre[1]) <= radius) greatest = share;
  }
  return greatest;
}

std::vector<ElementIndex> FailureMap::failed(double share) const {
  std::vector<ElementIndex> elements;
  for (const auto& [element, lost] : lost_)
    if (lost >= share) elements.push_back(element);
  std::sort(elements.begin(), elements.end());
  return elements;
}

}  // namespace fissura::structure
