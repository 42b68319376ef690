// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "common/fracture_network/fracture_network.hpp"
#include "structure/joints/joint_state.hpp"

namespace fissura::structure {

/// Fracture vertices whose faces have just parted or are about to.
struct Arrivals {
  std::vector<VertexIndex> split;      ///< on fractures that there were before
  std::vector<VertexIndex> nucleated;  ///< on fractures that begin
};

/// The fracture vertices that become a part of `network`:
///  - nucleated ones, which are a part of it by themselves,
///  - split ones that the network reaches along fracture edges, and
///  - every natural fracture that it thereby touches, whole, with all natural fractures that this one is
///  connected to: they are full of pore
///    fluid. Cement that is not broken lets nothing through.
/// Of the mesh only vertices, edges and units are looked at.
/// @returns mesh vertices that are not in the network, ascending, each once
std::vector<VertexIndex> joining_vertices(const Mesh& mesh, const Joints& joints,
                                          const FractureNetwork& network, const Arrivals& arrivals);

}  // namespace fissura::structure
