// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/mesh/mesh.hpp"

namespace fissura::structure {

/// An element that took the place of a removed one so that the list stays dense; its corners are the same.
struct MovedElement {
  ElementIndex from = 0, to = 0;
};

/// What an insertion changed in a mesh, so that everything built from the mesh can follow where it was
/// touched. Indices are those after the change unless said otherwise; all lists ascend and hold an index
/// once.
///
/// Elements are removed from a patch and others made in it: first in the places of the removed ones, then at
/// the end. If fewer are made than removed, the places left over are filled from the end (`moved`). Nodes
/// keep their index; those that nothing uses any more are listed in Mesh::unused_nodes and are the first to
/// stand for a new node.
struct MeshChange {
  std::size_t elements_before = 0, nodes_before = 0;
  std::vector<ElementIndex> removed;  ///< by their index before
  std::vector<ElementIndex> made;     ///< new elements
  std::vector<ElementIndex>
      rewired;  ///< same triangle, but a corner has another node: the side of a new fracture it lies on
  std::vector<MovedElement> moved;
  std::vector<NodeIndex> new_nodes;     ///< index now stands for another node than before
  std::vector<NodeIndex> unused_nodes;  ///< in use before, not any more
  std::vector<NodeIndex>
      touched_nodes;  ///< every node of a made, removed or rewired element that is in use now
  std::vector<VertexIndex> new_vertices;  ///< of the fractures
  std::vector<UnitIndex> new_units;       ///< contact units that did not exist before
  std::vector<UnitIndex> changed_units;   ///< units that did, with another face, length or node
};

}  // namespace fissura::structure
