// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "common/fracture_network/fracture_network.hpp"
#include "structure/joints/joint_state.hpp"

namespace fissura::structure {

/// The closed vertices ahead of a tip whose wet stress has reached the strength:
///   T_n + p_adjacent >= f_t,tip
/// with T_n the normal traction that holds the faces together and p_adjacent the pressure on the faces of the
/// last vertex of the network. The fluid pressure counts because the process zone is wet at this scale: the
/// dry zone is centimetres long, far below the mesh. At most one vertex per tip.
/// @returns mesh vertices, ascending, each once
std::vector<VertexIndex> vertices_to_release(const Mesh& mesh, const Joints& joints,
                                             const FractureNetwork& network);

/// Lets those faces of `vertex` separate that were held together: closed, dry, with the whole cohesion.
void release(const Mesh& mesh, VertexIndex vertex, Joints& joints);

}  // namespace fissura::structure
