// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "structure/fracture/patch_mesh.hpp"
#include "structure/mesh/node_elements.hpp"

namespace fissura::structure {

/// A point of the patch on the new line and its fracture vertex, which may be one to come.
struct LinePoint {
  std::uint32_t point = 0;
  VertexIndex vertex = 0;
};

struct WedgeInput {
  const Mesh& mesh;
  const NodeElements& node_elements;
  const std::vector<ElementIndex>& elements;  ///< of the patch, ascending
  const PatchOutline& outline;
  const PatchMesh& patch;
  const std::vector<LinePoint>& line;
  const std::vector<FractureEdge>& new_edges;
};

/// The corners around a point between two fracture edges (or sides of the domain) that follow one another.
struct Wedge {
  std::uint32_t point = 0;          ///< of the patch
  std::optional<NodeIndex> source;  ///< the node it had; nothing at a new point
  bool copies = false;              ///< another wedge keeps `source`; this one gets a copy of it
  std::uint32_t node = 0;           ///< to be set by the caller
};

/// A corner of a new triangle of the patch, or of an element outside it.
struct WedgeCorner {
  bool outside = false;
  std::uint32_t element = 0;  ///< triangle of the patch mesh, or element of the mesh
  int corner = 0;
  std::uint32_t wedge = 0;
  std::optional<VertexIndex> vertex, next, last;  ///< fracture vertices at this corner and, counter-clockwise, the two others
};

struct WedgeNodes {
  std::vector<Wedge> wedges;
  std::vector<WedgeCorner> corners;

  /// Node at `vertex` of the element to the left of the edge from `vertex` to `other`.
  [[nodiscard]] std::optional<std::uint32_t> node_left_of(VertexIndex vertex, VertexIndex other) const;
  /// The same of the element to its right.
  [[nodiscard]] std::optional<std::uint32_t> node_right_of(VertexIndex vertex, VertexIndex other) const;
};

/// Wedges of all points of the patch on fractures or on the new line.
WedgeNodes assign_wedges(const WedgeInput& input);

}  // namespace fissura::structure
