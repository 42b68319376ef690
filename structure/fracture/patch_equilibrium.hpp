// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/structure_state.hpp"

namespace fissura::structure {

/// Nodes all of whose elements are among `elements` (ascending): they can move without a change of stress
/// anywhere else. Ascending.
std::vector<NodeIndex> inner_nodes(const Mesh& mesh, const NodeElements& node_elements,
                                   const std::vector<ElementIndex>& elements);

struct PatchEquilibriumReport {
  bool converged = false;
  int iterations = 0;
  double residual = 0;  ///< largest displacement of the last iteration over the largest of all [-]
};

/// Moves the inner nodes of `elements` (ascending) into static equilibrium: internal forces of the elements,
/// external forces, and on the contact units between inner nodes cohesion, fluid pressure and contact. Damage
/// and plastic strain of `records` (ascending, of any elements) are kept; the cohesion loads from, or unloads
/// below, the greatest separation of `joints`. Newton's method with the tangents of the elements by
/// differences and the secants of the faces. Displacements stay as they were unless it converged.
[[nodiscard]] PatchEquilibriumReport equilibrate(const StructureModel& model, const Geometry& geometry,
                                                 const std::vector<ElementIndex>& elements,
                                                 const std::vector<ElementDamage>& records,
                                                 const Joints& joints, std::vector<double>& displacement);

}  // namespace fissura::structure
