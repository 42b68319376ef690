// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/dynamics/damage_state.hpp"
#include "structure/mesh/mesh.hpp"
#include "structure/mesh/mesh_change.hpp"

/// Failure carried across a change of the mesh, never averaged: means smear a crack over its neighbours.
namespace fissura::structure {

/// What is needed of the mesh before the change; everything by the element indices before.
struct DamageBefore {
  std::vector<ElementDamage> records;   ///< all, ascending in the element
  std::vector<ElementIndex> removed;    ///< of the patch, ascending
  std::vector<Point> removed_centroid;  ///< of each of `removed` [m]
};

/// To be taken before the mesh changes. `removed` is MeshChange::removed.
DamageBefore damage_before_change(const Mesh& mesh, const Tiles& tiles, const Damage& damage,
                                  const std::vector<ElementIndex>& removed);

/// A record on another triangle: the share of strength lost, crack normal and plastic history stay, while
/// band length and strength are those of the triangle and equivalent strain and damage follow from them.
ElementDamage record_on(const ElementDamage& given, const Mesh& mesh, ElementIndex element,
                        const RockFailure& law);

/// Records of the elements after the change, ascending in the element, for damage_from_records(). An element
/// that was kept, moved or rewired has its record bit for bit. A made element takes the record of the removed
/// element with the nearest centroid (of two as near, the one with the lower index) as record_on() gives it,
/// or none if that has none. `mesh` is the one after the change.
std::vector<ElementDamage> carry_damage(const DamageBefore& before, const MeshChange& change,
                                        const Mesh& mesh, const RockFailure& law);

}  // namespace fissura::structure
