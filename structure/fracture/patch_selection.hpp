// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/fracture/tip_size_field.hpp"
#include "structure/mesh/node_elements.hpp"

namespace fissura::structure {

/// Where a patch is wanted.
struct PatchPlace {
  NodeIndex tip = 0;     ///< node at the tip
  Point begin{}, end{};  ///< of the new segment [m]
  double radius = 0;     ///< elements with their centroid nearer than this to the segment belong to the patch [m]
};

enum class CoarseElements {
  refined,  ///< those too coarse for a tip there belong to the patch
  left      ///< they stay as they are
};

struct PatchChoice {
  std::vector<ElementIndex> elements;  ///< ascending
  TipSizeField field;                  ///< target size of what replaces them
};

/// The elements an insertion replaces: those around the new segment, and those that have become too coarse for a tip there, with their
/// neighbours. Only elements connected to the tip through nodes are looked at. Once an element is too coarse, the mesh is refined for
/// a tip a few segments farther on the same straight line too, so that not every insertion has to.
PatchChoice choose_patch(const Mesh& mesh, const NodeElements& node_elements, const MeshControls& controls,
                         const PatchPlace& place, CoarseElements coarse_elements);

}  // namespace fissura::structure
