// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "structure/mesh/mesh.hpp"
#include "structure/mesh/mesh_change.hpp"

namespace fissura::structure {

/// The elements around each node of a mesh.
class NodeElements {
 public:
  NodeElements() = default;
  explicit NodeElements(const Mesh& mesh);

  /// Elements with a corner at `node`, ascending; none of an unused node. Valid until the next follow().
  [[nodiscard]] std::span<const ElementIndex> of(NodeIndex node) const;

  /// After the mesh changed. Takes time in proportion to the change, seldom to the mesh.
  void follow(const Mesh& mesh, const MeshChange& change);

 private:
  struct Row {
    std::uint32_t first = 0, count = 0, room = 0;
  };

  void replace(NodeIndex node, std::span<const ElementIndex> elements);
  void close_gaps();

  std::vector<Row> rows_;  // of each node: a stretch of elements_
  std::vector<ElementIndex> elements_;
  std::size_t used_ = 0;  // entries of elements_ that belong to a row
};

/// Nodes whose elements, place or use changed: touched, new and unused ones; ascending.
std::vector<NodeIndex> changed_nodes(const MeshChange& change);

/// Elements that did not exist before in this place with these corners: made, rewired and moved ones (by
/// their index now); ascending.
std::vector<ElementIndex> changed_elements(const MeshChange& change);

}  // namespace fissura::structure
