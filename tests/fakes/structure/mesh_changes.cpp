// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/structure/mesh_changes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "structure/dynamics/triangle.hpp"
#include "structure/mesh/node_elements.hpp"

namespace fissura::structure::fakes {

namespace {

using Corners = std::array<NodeIndex, 3>;

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

struct Replacement {
  std::set<ElementIndex> removed;
  std::vector<Corners> made;
  std::set<NodeIndex> new_nodes, unused_nodes;
};

NodeIndex new_node(Mesh& mesh, const Point& position) {
  if (mesh.unused_nodes.empty()) {
    mesh.position.push_back(position);
    return static_cast<NodeIndex>(mesh.position.size() - 1);
  }
  const NodeIndex node = mesh.unused_nodes.front();
  mesh.unused_nodes.erase(mesh.unused_nodes.begin());
  mesh.position[node] = position;
  return node;
}

void fill_gaps(Mesh& mesh, std::vector<ElementIndex> gaps, MeshChange& change) {
  while (!gaps.empty()) {
    const auto last = static_cast<ElementIndex>(mesh.elements.size() - 1);
    if (gaps.back() == last) {
      gaps.pop_back();
    } else {
      mesh.elements[gaps.front()] = mesh.elements[last];
      change.moved.push_back({last, gaps.front()});
      gaps.erase(gaps.begin());
    }
    mesh.elements.pop_back();
  }
}

MeshChange apply(Mesh& mesh, const Replacement& replacement, MeshChange change) {
  change.removed.assign(replacement.removed.begin(), replacement.removed.end());
  change.new_nodes.assign(replacement.new_nodes.begin(), replacement.new_nodes.end());
  change.unused_nodes.assign(replacement.unused_nodes.begin(), replacement.unused_nodes.end());
  std::set<NodeIndex> touched;
  for (const ElementIndex element : change.removed)
    touched.insert(mesh.elements[element].begin(), mesh.elements[element].end());
  for (const Corners& corners : replacement.made) touched.insert(corners.begin(), corners.end());
  for (const NodeIndex node : change.unused_nodes) touched.erase(node);
  change.touched_nodes.assign(touched.begin(), touched.end());

  std::size_t filled = 0;
  for (const Corners& corners : replacement.made) {
    if (filled == change.removed.size()) {
      change.made.push_back(static_cast<ElementIndex>(mesh.elements.size()));
      mesh.elements.push_back(corners);
    } else {
      change.made.push_back(change.removed[filled]);
      mesh.elements[change.removed[filled++]] = corners;
    }
  }
  fill_gaps(mesh, {change.removed.begin() + static_cast<std::ptrdiff_t>(filled), change.removed.end()},
            change);
  mesh.unused_nodes.insert(mesh.unused_nodes.end(), change.unused_nodes.begin(), change.unused_nodes.end());
  std::sort(mesh.unused_nodes.begin(), mesh.unused_nodes.end());
  return change;
}

MeshChange unchanged(const Mesh& mesh) {
  MeshChange change;
  change.elements_before = mesh.elements.size();
  change.nodes_before = mesh.position.size();
  return change;
}

double double_area(const Mesh& mesh, const Corners& corners) {
  const Point &p = mesh.position[corners[0]], &q = mesh.position[corners[1]], &r = mesh.position[corners[2]];
  return (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
}

// The corners around a node in counter-clockwise order, if there are four.
std::optional<std::array<NodeIndex, 4>> ring(const Mesh& mesh, const NodeElements& elements, NodeIndex node) {
  if (elements.of(node).size() != 4) return std::nullopt;
  const auto edge_across = [&](ElementIndex element) {
    const Corners& c = mesh.elements[element];
    const auto at = static_cast<std::size_t>(std::find(c.begin(), c.end(), node) - c.begin());
    return std::pair(c[(at + 1) % 3], c[(at + 2) % 3]);
  };
  std::array<NodeIndex, 4> corners{};
  NodeIndex next = edge_across(elements.of(node)[0]).first;
  for (NodeIndex& corner : corners) {
    corner = next;
    for (const ElementIndex element : elements.of(node))
      if (edge_across(element).first == corner) next = edge_across(element).second;
  }
  if (next != corners[0]) return std::nullopt;
  return corners;
}

}  // namespace

MeshChange refine(Mesh& mesh, const Point& centre, double radius) {
  const MeshChange change = unchanged(mesh);
  Replacement replacement;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    if (distance(centroid(mesh, element), centre) > radius) continue;
    const auto [a, b, c] = mesh.elements[element];
    const NodeIndex middle = new_node(mesh, centroid(mesh, element));
    replacement.removed.insert(element);
    replacement.new_nodes.insert(middle);
    replacement.made.insert(replacement.made.end(), {{a, b, middle}, {b, c, middle}, {c, a, middle}});
  }
  return apply(mesh, replacement, change);
}

MeshChange coarsen(Mesh& mesh, const Point& centre, double radius) {
  const NodeElements elements(mesh);
  std::vector<bool> stays(mesh.position.size(), false);
  for (const auto& side : mesh.side_nodes)
    for (const NodeIndex node : side) stays[node] = true;
  for (const ContactUnit& unit : mesh.units) stays[unit.minus] = stays[unit.plus] = true;
  for (const FractureVertex& vertex : mesh.vertices) stays[vertex.node] = true;
  Replacement replacement;
  for (NodeIndex node = 0; node < mesh.position.size(); ++node) {
    if (stays[node] || distance(mesh.position[node], centre) > radius) continue;
    const auto corners = ring(mesh, elements, node);
    if (!corners) continue;
    const auto [a, b, c, d] = *corners;
    if (!(double_area(mesh, {a, b, c}) > 0 && double_area(mesh, {a, c, d}) > 0)) continue;
    for (const NodeIndex corner : *corners) stays[corner] = true;
    replacement.removed.insert(elements.of(node).begin(), elements.of(node).end());
    replacement.unused_nodes.insert(node);
    replacement.made.insert(replacement.made.end(), {{a, b, c}, {a, c, d}});
  }
  return apply(mesh, replacement, unchanged(mesh));
}

MeshChange tear(Mesh& mesh, const Point& centre) {
  MeshChange change = unchanged(mesh);
  const NodeElements elements(mesh);
  NodeIndex node = 0;
  for (NodeIndex n = 0; n < mesh.position.size(); ++n)
    if (!elements.of(n).empty() && distance(mesh.position[n], centre) < distance(mesh.position[node], centre))
      node = n;
  const NodeIndex copy = new_node(mesh, Point(mesh.position[node]));
  change.new_nodes = {copy};
  std::set<NodeIndex> touched{node, copy};
  for (const ElementIndex element : elements.of(node)) {
    if (centroid(mesh, element)[1] < mesh.position[node][1]) continue;
    std::replace(mesh.elements[element].begin(), mesh.elements[element].end(), node, copy);
    change.rewired.push_back(element);
    touched.insert(mesh.elements[element].begin(), mesh.elements[element].end());
  }
  change.touched_nodes.assign(touched.begin(), touched.end());
  change.new_units = {static_cast<UnitIndex>(mesh.units.size())};
  change.new_vertices = {static_cast<VertexIndex>(mesh.vertices.size())};
  mesh.vertices.push_back({mesh.position[node], change.new_units, node, {}});
  mesh.units.push_back({node, copy, {0, 1}, 1, change.new_vertices.front(), 0});
  return change;
}

}  // namespace fissura::structure::fakes
