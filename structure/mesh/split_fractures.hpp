// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "structure/mesh/mesh.hpp"
#include "structure/mesh/planar_mesh.hpp"

namespace fissura::structure {

/// Cuts the mesh along every fracture line, whatever its kind, and lists the contact units.
///
/// The triangles around a vertex of the lines fall into wedges between its line edges (and the sides of the
/// domain); each wedge gets a node of its own. A line that ends inside the rock leaves one wedge, so its end
/// stays whole. On every line edge the triangles to the left and right of its direction name the plus and
/// minus node at each of its ends; half of the edge goes to either pair, and equal pairs are one ContactUnit.
/// Where edges of opposite direction share a pair, the first in the list decides which node is `plus`.
/// Result: positions, elements, vertices, edges and units; no side_nodes. Every line edge must be an edge of
/// the mesh.
Mesh split_fractures(const PlanarMesh& planar, std::span<const FractureLine> lines);

}  // namespace fissura::structure
