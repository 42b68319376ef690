// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/damage_state.hpp"

#include <algorithm>

namespace fissura::structure {

Damage intact_damage(const Tiles& tiles) {
  Damage damage;
  for (const Tile& tile : tiles.tile) {
    const std::size_t places = tile.groups.size() * group_width;
    damage.push_back({std::vector<std::uint8_t>(places, 0), std::vector<std::uint16_t>(places, 0), {}});
  }
  return damage;
}

std::vector<ElementDamage> damage_records(const Tiles& tiles, const Damage& damage) {
  std::vector<ElementDamage> records;
  for (std::size_t t = 0; t < damage.size(); ++t)
    for (std::size_t place = 0; place < tiles.tile[t].elements.size(); ++place)
      if (damage[t].cracked[place])
        records.push_back({tiles.tile[t].elements[place], damage[t].record[damage[t].record_of[place]]});
  std::sort(records.begin(), records.end(),
            [](const ElementDamage& a, const ElementDamage& b) { return a.element < b.element; });
  return records;
}

Damage damage_from_records(const Tiles& tiles, const std::vector<ElementDamage>& records) {
  Damage damage = intact_damage(tiles);
  for (std::size_t t = 0; t < tiles.tile.size(); ++t)
    for (std::size_t place = 0; place < tiles.tile[t].elements.size(); ++place) {
      const ElementIndex element = tiles.tile[t].elements[place];
      const auto found =
          std::lower_bound(records.begin(), records.end(), element,
                           [](const ElementDamage& a, ElementIndex b) { return a.element < b; });
      if (found == records.end() || found->element != element) continue;
      damage[t].cracked[place] = 1;
      damage[t].record_of[place] = static_cast<std::uint16_t>(damage[t].record.size());
      damage[t].record.push_back(found->history);
    }
  return damage;
}

}  // namespace fissura::structure
