// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/fracture/failure_path.hpp"

namespace fissura::structure {

/// Where failure may start around the tips that grow along failure paths. A crack band left to itself follows
/// the rows of the mesh, the fracture follows the stress; the corridor makes the band run where the fracture
/// will go.
struct TipCorridors {
  /// Within 7 tip_size of a tip and more than 0.7 tip_size off every predicted path: no failure may start
  /// there; ascending.
  std::vector<ElementIndex> forbidden;
};

/// Corridors along the march ahead of every tip, six tip_size long and continued straight on.
TipCorridors tip_corridors(const RockNow& rock);

}  // namespace fissura::structure
