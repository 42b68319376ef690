// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/damage_transfer.hpp"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <unordered_set>

#include "common/errors.hpp"
#include "structure/dynamics/triangle.hpp"
#include "structure/material/crack_band.hpp"

namespace fissura::structure {

namespace {

bool earlier(const ElementDamage& a, const ElementDamage& b) {
  return a.element < b.element;
}

const ElementDamage* find_record(const std::vector<ElementDamage>& records, ElementIndex element) {
  const auto found =
      std::lower_bound(records.begin(), records.end(), ElementDamage{element, {}, {}}, earlier);
  return found != records.end() && found->element == element ? &*found : nullptr;
}

ElementIndex nearest_removed(const DamageBefore& before, const Point& position) {
  double least = std::numeric_limits<double>::infinity();
  ElementIndex nearest = before.removed.front();
  for (std::size_t i = 0; i < before.removed.size(); ++i) {
    const double dx = before.removed_centroid[i][0] - position[0],
                 dy = before.removed_centroid[i][1] - position[1];
    const double distance_squared = dx * dx + dy * dy;
    if (distance_squared >= least) continue;
    least = distance_squared;
    nearest = before.removed[i];
  }
  return nearest;
}

}  // namespace

ElementDamage record_on(const ElementDamage& given, const Mesh& mesh, ElementIndex element,
                        const RockFailure& law) {
  const auto& [a, b, c] = mesh.elements[element];
  const double band =
      crack_band_length({mesh.position[a], mesh.position[b], mesh.position[c]}, given.history.normal);
  ElementDamage result{element, undamaged_band(law.tension, given.history.normal, band), given.plastic};
  grow_damage(law.tension,
              strain_of_lost_strength(law.tension, result.history.tensile_strength, band,
                                      lost_strength(law.tension, given.history)),
              result.history);
  result.plastic.worn *= given.history.band_length / band;
  return result;
}

DamageBefore damage_before_change(const Mesh& mesh, const Tiles& tiles, const Damage& damage,
                                  const std::vector<ElementIndex>& removed) {
  DamageBefore before{damage_records(tiles, damage), removed, {}};
  for (const ElementIndex element : removed) before.removed_centroid.push_back(centroid(mesh, element));
  return before;
}

std::vector<ElementDamage> carry_damage(const DamageBefore& before, const MeshChange& change,
                                        const Mesh& mesh, const RockFailure& law) {
  ENSURE(before.removed == change.removed);
  const std::unordered_set<ElementIndex> removed(change.removed.begin(), change.removed.end());
  std::unordered_map<ElementIndex, ElementIndex> moved;
  for (const MovedElement& element : change.moved) moved.emplace(element.from, element.to);

  std::vector<ElementDamage> after;
  for (const ElementDamage& record : before.records) {
    if (removed.contains(record.element)) continue;
    const auto target = moved.find(record.element);
    after.push_back(record);
    if (target != moved.end()) after.back().element = target->second;
  }
  if (!before.removed.empty())
    for (const ElementIndex element : change.made)
      if (const auto* record = find_record(before.records, nearest_removed(before, centroid(mesh, element))))
        after.push_back(record_on(*record, mesh, element, law));
  std::sort(after.begin(), after.end(), earlier);
  return after;
}

}  // namespace fissura::structure
