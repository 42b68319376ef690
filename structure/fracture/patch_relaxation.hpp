// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/fracture/patch_outline.hpp"
#include "structure/fracture/tip_size_field.hpp"

namespace fissura::structure {

/// The points of a patch while they are placed. Internal to patch_mesh.
struct PatchProblem {
  std::vector<Point> points;  ///< fixed ones first [m]
  std::size_t fixed = 0;
  std::vector<PointPair> edges;       ///< among the fixed points; kept
  std::vector<std::uint32_t> origin;  ///< of each free point: its point of the outline or PatchMesh::added
  std::vector<PointPair> sides;       ///< edges of the outline, directed with the patch to the left
  const PatchSizeField* field = nullptr;
};

/// Adds, removes and moves free points until the triangles are good; returns the triangles inside the patch. Throws SolverError if an
/// edge cannot be kept.
std::vector<PointTriple> relax_patch(PatchProblem& problem);

}  // namespace fissura::structure
