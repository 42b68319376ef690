// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "structure/dynamics/tiles.hpp"
#include "structure/material/rock_failure.hpp"

/// The failure of the body, kept beside the tiles because it changes in every step. An element has a record
/// only from the time on at which it left its elastic range, by cracking or by shearing.
namespace fissura::structure {

struct TileDamage {
  std::vector<std::uint8_t>
      failed;  ///< of each place of the tile: 1 if it has a record; padded like the groups
  std::vector<std::uint16_t> record_of;  ///< place -> index into `record`, valid where `failed`
  std::vector<DamageHistory> record;     ///< in the order of onset
  std::vector<PlasticHistory> plastic;   ///< of each of `record`
  std::vector<std::uint16_t> forbidden;  ///< places at which no record may start, ascending
};

/// One entry per tile; empty if bulk failure is off.
using Damage = std::vector<TileDamage>;

/// Undamaged state of every tile.
Damage intact_damage(const Tiles& tiles);

/// From now on elements without a record stay elastic whatever their stress if they are listed, in place of
/// those listed before: near an active tip, whose fracture is to take the failure. Elements that have a
/// record go on. A span without elements lets failure start everywhere. The list does not follow a change of
/// the mesh: it is given again then.
void forbid_onset(const Tiles& tiles, std::span<const ElementIndex> elements, Damage& damage);

/// The elements last listed, ascending.
std::vector<ElementIndex> elements_without_onset(const Tiles& tiles, const Damage& damage);

/// A record and its element in the mesh: how damage is stored, and carried from one set of tiles to another.
struct ElementDamage {
  ElementIndex element = 0;
  DamageHistory history;
  PlasticHistory plastic;
};

/// All records, ascending in the element.
std::vector<ElementDamage> damage_records(const Tiles& tiles, const Damage& damage);

/// Damage of `tiles` with these records, ascending in the element.
Damage damage_from_records(const Tiles& tiles, const std::vector<ElementDamage>& records);

}  // namespace fissura::structure
