// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "structure/mesh/mesh.hpp"
#include "structure/mesh/triangulate.hpp"

namespace fissura::structure {

/// A patch of elements as a planar problem. A point stands for all nodes at one place, on whatever side of a fracture.
struct PatchOutline {
  std::vector<Point> points;              ///< corners of the patch: those on outline and fractures first, then the free ones [m]
  std::size_t fixed = 0;                  ///< points that must stay
  std::vector<NodeIndex> node;            ///< one of the nodes of each point
  std::vector<PointPair> sides;           ///< outline and fracture edges, directed with the patch to the left
  std::vector<PointPair> edges;           ///< the same, each once; they must stay
  std::vector<std::array<Point, 3>> triangles;  ///< the patch as it was
  std::unordered_map<NodeIndex, std::uint32_t> point_of_node;
};

/// Node -> fracture vertex at the same place, of all vertices of the mesh.
std::unordered_map<NodeIndex, VertexIndex> fracture_nodes(const Mesh& mesh);

/// Outline of `elements`: every edge without an element of the patch beyond it (a split fracture edge has none).
PatchOutline outline(const Mesh& mesh, const std::vector<ElementIndex>& elements,
                     const std::unordered_map<NodeIndex, VertexIndex>& vertex_of_node);

/// Index of the triangle that holds `at`, or that comes nearest to holding it.
std::size_t triangle_around(const std::vector<std::array<Point, 3>>& triangles, const Point& at);

/// Whether a triangle holds `at` within rounding.
bool holds(const std::array<Point, 3>& triangle, const Point& at);

}  // namespace fissura::structure
