// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "common/fracture_network/fracture_network.hpp"
#include "structure/joints/joint_state.hpp"

/// The fractures of the mesh as the network that coupler and flow solver see. A network node is a fracture
/// vertex (its id is the vertex index), a segment is a fracture edge (its id is the edge index); mesh
/// vertices and edges are only ever appended.
namespace fissura::structure {

/// The mesh vertex of a network node.
inline VertexIndex vertex_of(NodeId node) {
  return static_cast<VertexIndex>(node);
}

/// Revision 0: every vertex inside an open fracture, exposed at time 0, and the perforations. Throws
/// InputError if there is none, or a perforation lies on none of them.
Insertion first_insertion(const Mesh& mesh, const Joints& joints, const Case& run_case);

/// The change that connects `vertices` (split fracture vertices not yet in `network`) to it at `time` [s];
/// nodes of the network at new junctions are updated. A vertex on a natural fracture joins saturated, with
/// pore fluid at formation pressure. Of the mesh only lines, vertices and edges are looked at, and of
/// vertices that are split just now no unit is known yet.
Insertion connect(const Mesh& mesh, const FractureNetwork& network, const std::vector<VertexIndex>& vertices,
                  const Case& run_case, double time);

}  // namespace fissura::structure
