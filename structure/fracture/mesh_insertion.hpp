// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/fracture/growth_plan.hpp"
#include "structure/mesh/mesh_change.hpp"

namespace fissura::structure {

/// The change made by a plan, with the nodes that its planned nodes have become.
struct MeshInsertion {
  MeshChange change;
  std::vector<std::vector<NodeIndex>> node;  ///< of each patch: index in the mesh of PatchPlan::nodes

  /// Index in the mesh of a node planned in `patch`.
  [[nodiscard]] NodeIndex index_of(std::size_t patch, PlannedNodeIndex planned) const {
    return planned < change.nodes_before ? planned : node[patch][planned - change.nodes_before];
  }
};

/// Carries out a plan on the mesh: elements, nodes, fracture vertices and edges, contact units, side nodes. Vertices, edges and units keep
/// their indices; new ones follow them.
MeshInsertion insert_into_mesh(const GrowthPlan& plan, Mesh& mesh);

}  // namespace fissura::structure
