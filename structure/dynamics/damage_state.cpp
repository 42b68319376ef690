// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/damage_state.hpp"

#include <algorithm>
#include <unordered_set>

namespace fissura::structure {

Damage intact_damage(const Tiles& tiles) {
  Damage damage;
  for (const Tile& tile : tiles.tile) {
    const std::size_t places = tile.groups.size() * group_width;
    damage.push_back(
        {std::vector<std::uint8_t>(places, 0), std::vector<std::uint16_t>(places, 0), {}, {}, {}});
  }
  return damage;
}

void forbid_onset(const Tiles& tiles, std::span<const ElementIndex> elements, Damage& damage) {
  const std::unordered_set<ElementIndex> listed(elements.begin(), elements.end());
  for (std::size_t t = 0; t < damage.size(); ++t) {
    damage[t].forbidden.clear();
    if (listed.empty()) continue;
    for (std::size_t place = 0; place < tiles.tile[t].elements.size(); ++place)
      if (listed.contains(tiles.tile[t].elements[place]))
        damage[t].forbidden.push_back(static_cast<std::uint16_t>(place));
  }
}

std::vector<ElementIndex> elements_without_onset(const Tiles& tiles, const Damage& damage) {
  std::vector<ElementIndex> elements;
  for (std::size_t t = 0; t < damage.size(); ++t)
    for (const std::uint16_t place : damage[t].forbidden) elements.push_back(tiles.tile[t].elements[place]);
  std::sort(elements.begin(), elements.end());
  return elements;
}

std::vector<ElementDamage> damage_records(const Tiles& tiles, const Damage& damage) {
  std::vector<ElementDamage> records;
  for (std::size_t t = 0; t < damage.size(); ++t)
    for (std::size_t place = 0; place < tiles.tile[t].elements.size(); ++place)
      if (damage[t].failed[place]) {
        const std::size_t record = damage[t].record_of[place];
        records.push_back(
            {tiles.tile[t].elements[place], damage[t].record[record], damage[t].plastic[record]});
      }
  std::sort(records.begin(), records.end(),
            [](const ElementDamage& a, const ElementDamage& b) { return a.element < b.element; });
  return records;
}

Damage damage_from_records(const Tiles& tiles, const std::vector<ElementDamage>& records) {
  Damage damage = intact_damage(tiles);
  if (records.empty()) return damage;
  for (std::size_t t = 0; t < tiles.tile.size(); ++t)
    for (std::size_t place = 0; place < tiles.tile[t].elements.size(); ++place) {
      const ElementIndex element = tiles.tile[t].elements[place];
      const auto found =
          std::lower_bound(records.begin(), records.end(), element,
                           [](const ElementDamage& a, ElementIndex b) { return a.element < b; });
      if (found == records.end() || found->element != element) continue;
      damage[t].failed[place] = 1;
      damage[t].record_of[place] = static_cast<std::uint16_t>(damage[t].record.size());
      damage[t].record.push_back(found->history);
      damage[t].plastic.push_back(found->plastic);
    }
  return damage;
}

}  // namespace fissura::structure
