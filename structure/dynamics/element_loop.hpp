// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "structure/dynamics/damage_state.hpp"
#include "structure/dynamics/node_record.hpp"
#include "structure/dynamics/read_ahead.hpp"
#include "structure/dynamics/tiles.hpp"
#include "structure/material/elasticity.hpp"
#include "structure/material/rock_failure.hpp"

/// Internal forces of one tile: the hot loop of the project.
///
///   f_i = - A sigma_total . grad N_i ,   sigma_total = (s - D s+) - alpha p I ,   s = sigma_0 + C : eps(u)
///
/// First pass: every element as if it were elastic, in lanes. With failure on, elements that leave the
/// elastic range or already have a record are put on a list with zero force instead; the second pass computes
/// those (rock_failure.hpp). Forces are added in a fixed order, first pass before second.
namespace fissura::structure {

/// A thread's own copy of the nodes of the tile it is working on. Stays in the first-level cache.
struct TileWorkspace {
  std::vector<NodeRecord> record;
  std::vector<std::array<double, 2>> force;  ///< internal force of each tile-local node [N/m]
  std::vector<std::uint16_t> listed;         ///< places of the second pass
};

/// Copies coordinates and displacements of the tile's nodes and clears their forces.
/// `displacement` is interleaved x, y per node of the mesh [m].
void gather_nodes(const Tile& tile, const std::vector<double>& displacement, TileWorkspace& workspace);

/// Adds the internal forces of elastic elements to `workspace.force`.
void add_elastic_forces(const Tile& tile, const Elasticity& moduli, const ReadAhead& ahead,
                        TileWorkspace& workspace);

/// The same of rock that fails, to the present strain. An element whose undamaged stress exceeds
/// `lowest_strength` [Pa], at most the strength of the weakest element, or Mohr-Coulomb is looked at in the
/// second pass.
void add_failing_forces(const Tile& tile, const Elasticity& moduli, const RockFailure& law,
                        double lowest_strength, const ReadAhead& ahead, TileDamage& damage,
                        TileWorkspace& workspace);

}  // namespace fissura::structure
