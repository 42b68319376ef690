// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/patch_outline.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "structure/mesh/triangle_shape.hpp"

namespace fissura::structure {

namespace {

constexpr double rounding = 1e-9;  // of a barycentric coordinate

double least_barycentric(const std::array<Point, 3>& t, const Point& at) {
  const double area = twice_area(t[0], t[1], t[2]);
  return std::min({twice_area(at, t[1], t[2]), twice_area(t[0], at, t[2]), twice_area(t[0], t[1], at)}) / area;
}

}  // namespace

std::unordered_map<NodeIndex, VertexIndex> fracture_nodes(const Mesh& mesh) {
  std::unordered_map<NodeIndex, VertexIndex> vertex_of_node;
  for (VertexIndex v = 0; v < mesh.vertices.size(); ++v) {
    vertex_of_node.emplace(mesh.vertices[v].node, v);
    for (const UnitIndex unit : mesh.vertices[v].units) {
      vertex_of_node.emplace(mesh.units[unit].minus, v);
      vertex_of_node.emplace(mesh.units[unit].plus, v);
    }
  }
  return vertex_of_node;
}

PatchOutline outline(const Mesh& mesh, const std::vector<ElementIndex>& elements,
                     const std::unordered_map<NodeIndex, VertexIndex>& vertex_of_node) {
  std::set<std::pair<NodeIndex, NodeIndex>> directed;
  for (const ElementIndex element : elements)
    for (int k = 0; k < 3; ++k) directed.emplace(mesh.elements[element][k], mesh.elements[element][(k + 1) % 3]);
  std::set<NodeIndex> on_outline;
  std::vector<std::pair<NodeIndex, NodeIndex>> bare;
  for (const auto& [a, b] : directed)
    if (!directed.contains({b, a})) {
      bare.emplace_back(a, b);
      on_outline.insert({a, b});
    }

  PatchOutline result;
  std::unordered_map<VertexIndex, std::uint32_t> point_of_vertex;
  const auto add = [&](NodeIndex node) {
    const auto vertex = vertex_of_node.find(node);
    if (vertex != vertex_of_node.end())
      if (const auto known = point_of_vertex.find(vertex->second); known != point_of_vertex.end()) {
        result.point_of_node.emplace(node, known->second);
        return;
      }
    const auto point = static_cast<std::uint32_t>(result.points.size());
    if (!result.point_of_node.emplace(node, point).second) return;
    if (vertex != vertex_of_node.end()) point_of_vertex.emplace(vertex->second, point);
    result.points.push_back(mesh.position[node]);
    result.node.push_back(node);
  };
  const auto fixed = [&](NodeIndex node) { return on_outline.contains(node) || vertex_of_node.contains(node); };
  for (const ElementIndex element : elements)
    for (const NodeIndex node : mesh.elements[element])
      if (fixed(node)) add(node);
  result.fixed = result.points.size();
  for (const ElementIndex element : elements)
    for (const NodeIndex node : mesh.elements[element]) add(node);

  std::set<PointPair> edges;
  for (const auto& [a, b] : bare) {
    const std::uint32_t p = result.point_of_node.at(a), q = result.point_of_node.at(b);
    result.sides.push_back({p, q});
    if (edges.insert({std::min(p, q), std::max(p, q)}).second) result.edges.push_back({p, q});
  }
  for (const ElementIndex element : elements) {
    const auto& [a, b, c] = mesh.elements[element];
    result.triangles.push_back({mesh.position[a], mesh.position[b], mesh.position[c]});
  }
  return result;
}

std::size_t triangle_around(const std::vector<std::array<Point, 3>>& triangles, const Point& at) {
  std::size_t best = 0;
  double greatest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const double inside = least_barycentric(triangles[k], at);
    if (inside <= greatest) continue;
    greatest = inside;
    best = k;
    if (inside >= 0) break;
  }
  return best;
}

bool holds(const std::array<Point, 3>& triangle, const Point& at) {
  return least_barycentric(triangle, at) >= -rounding;
}

}  // namespace fissura::structure
