// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "structure/dynamics/tiles.hpp"
#include "structure/material/rankine_damage.hpp"

/// The damage of the body, kept beside the tiles because it changes in every step. An element has a record
/// only from the onset of its damage on.
namespace fissura::structure {

struct TileDamage {
  std::vector<std::uint8_t>
      cracked;  ///< of each place of the tile: 1 if it has a record; padded like the groups
  std::vector<std::uint16_t> record_of;  ///< place -> index into `record`, valid where `cracked`
  std::vector<DamageHistory> record;     ///< in the order of onset
};

/// One entry per tile; empty if bulk failure is off.
using Damage = std::vector<TileDamage>;

/// Undamaged state of every tile.
Damage intact_damage(const Tiles& tiles);

/// A record and its element in the mesh: how damage is stored, and carried from one set of tiles to another.
struct ElementDamage {
  ElementIndex element = 0;
  DamageHistory history;
};

/// All records, ascending in the element.
std::vector<ElementDamage> damage_records(const Tiles& tiles, const Damage& damage);

/// Damage of `tiles` with these records, ascending in the element.
Damage damage_from_records(const Tiles& tiles, const std::vector<ElementDamage>& records);

}  // namespace fissura::structure
