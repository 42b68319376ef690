// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/structure/fracture/mesh_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace fissura::structure::fakes {

namespace {

constexpr double same_area = 1e-12;
constexpr double same_length = 1e-12;  // [m]

class Inspection {
 public:
  Inspection(const Mesh& mesh, const Domain& domain) : mesh_(mesh), domain_(domain) {}

  std::vector<std::string> faults() {
    inspect_elements();
    inspect_places();
    inspect_edges();
    inspect_units();
    inspect_sides();
    return std::move(faults_);
  }

 private:
  template <class... Values>
  void note(fmt::format_string<Values...> text, Values&&... values) {
    faults_.push_back(fmt::format(text, std::forward<Values>(values)...));
  }

  [[nodiscard]] const Point& place(NodeIndex node) const { return mesh_.position[node]; }

  void inspect_elements() {
    double area = 0;
    for (ElementIndex element = 0; element < mesh_.elements.size(); ++element) {
      const double here = element_area(mesh_, element);
      if (!(here > 0)) note("element {} has the area {}", element, here);
      area += here;
      for (const NodeIndex node : mesh_.elements[element]) nodes_at_[place(node)].insert(node);
      for (int k = 0; k < 3; ++k) {
        const auto& corners = mesh_.elements[element];
        const auto [entry, is_new] =
            left_.emplace(std::pair{place(corners[k]), place(corners[(k + 1) % 3])}, element);
        if (!is_new) note("elements {} and {} lie on the same side of an edge", entry->second, element);
      }
    }
    const double whole = domain_.width * domain_.height;
    if (std::abs(area - whole) > same_area * whole) note("the elements fill {} m2 of {}", area, whole);
  }

  [[nodiscard]] bool on_side(const Point& at) const {
    return std::abs(at[0]) == domain_.width / 2 || std::abs(at[1]) == domain_.height / 2;
  }

  void inspect_places() {
    std::map<VertexIndex, std::size_t> degree;
    std::map<Point, VertexIndex> vertex_at;
    for (const FractureEdge& edge : mesh_.edges) {
      ++degree[edge.begin];
      ++degree[edge.end];
    }
    for (VertexIndex v = 0; v < mesh_.vertices.size(); ++v)
      if (!vertex_at.emplace(mesh_.vertices[v].position, v).second)
        note("two fracture vertices at one place, {} is the second", v);
    for (const auto& [at, nodes] : nodes_at_) {
      const auto vertex = vertex_at.find(at);
      if (vertex == vertex_at.end()) {
        if (nodes.size() != 1) note("{} nodes at ({}, {}), where no fracture is", nodes.size(), at[0], at[1]);
        continue;
      }
      const std::size_t sectors = degree[vertex->second] + (on_side(at) ? 1 : 0);
      if (nodes.size() != std::max<std::size_t>(sectors, 1))
        note("{} nodes at vertex {} with {} sectors", nodes.size(), vertex->second, sectors);
      if (!nodes.contains(mesh_.vertices[vertex->second].node))
        note("vertex {} names a node that is not there", vertex->second);
    }
    for (const auto& [at, vertex] : vertex_at)
      if (!nodes_at_.contains(at)) note("vertex {} has no node", vertex);
  }

  // The two elements at a fracture edge next to a tip share the tip's node.
  void inspect_edges() {
    std::set<std::pair<Point, Point>> fracture;
    for (const FractureEdge& edge : mesh_.edges) {
      const Point &a = mesh_.vertices[edge.begin].position, &b = mesh_.vertices[edge.end].position;
      fracture.insert({a, b});
      fracture.insert({b, a});
      if (std::abs(std::hypot(b[0] - a[0], b[1] - a[1]) - edge.length) > same_length)
        note("a fracture edge has the wrong length");
    }
    for (const auto& [edge, element] : left_) {
      const auto& [a, b] = edge;
      const auto across = left_.find({b, a});
      if (across == left_.end()) {
        const bool side = (a[0] == b[0] && std::abs(a[0]) == domain_.width / 2) ||
                          (a[1] == b[1] && std::abs(a[1]) == domain_.height / 2);
        if (!side) note("element {} has nothing beyond an edge inside the domain", element);
        continue;
      }
      const bool shared =
          corner(element, a) == corner(across->second, a) && corner(element, b) == corner(across->second, b);
      const bool torn =
          fracture.contains(edge) && !(nodes_at_.at(a).size() == 1 && nodes_at_.at(b).size() == 1);
      if (shared == torn) note("the edge of element {} is {}", element, shared ? "welded" : "torn");
    }
  }

  [[nodiscard]] NodeIndex corner(ElementIndex element, const Point& at) const {
    for (const NodeIndex node : mesh_.elements[element])
      if (place(node) == at) return node;
    return 0xffffffffu;
  }

  struct Faces {
    std::array<double, 2> face{};
    double length = 0;
  };

  void inspect_units() {
    using Pair = std::pair<NodeIndex, NodeIndex>;
    std::map<Pair, Faces> expected;  // face towards the second
    for (EdgeIndex k = 0; k < mesh_.edges.size(); ++k) {
      const FractureEdge& edge = mesh_.edges[k];
      for (const VertexIndex end : {edge.begin, edge.end}) {
        const auto& listed = mesh_.vertices[end].edges;
        if (std::count(listed.begin(), listed.end(), k) != 1)
          note("vertex {} does not list edge {} once", end, k);
      }
      const Point &a = mesh_.vertices[edge.begin].position, &b = mesh_.vertices[edge.end].position;
      const auto left = left_.find({a, b}), right = left_.find({b, a});
      if (left == left_.end() || right == left_.end()) {
        note("a fracture edge is no edge of the mesh");
        continue;
      }
      for (const Point& end : {a, b}) {
        const NodeIndex plus = corner(left->second, end), minus = corner(right->second, end);
        const UnitIndex named = edge.unit[end == a ? 0 : 1];
        if (plus == minus) {
          if (named != no_unit) note("edge {} names a unit where it is not split", k);
          continue;
        }
        if (named >= mesh_.units.size() ||
            std::minmax(mesh_.units[named].minus, mesh_.units[named].plus) != std::minmax(minus, plus))
          note("edge {} names another unit than that of its faces", k);
        const bool ascending = minus < plus;
        Faces& faces = expected[std::minmax(minus, plus)];
        faces.face[0] -= (ascending ? 0.5 : -0.5) * (b[1] - a[1]);
        faces.face[1] += (ascending ? 0.5 : -0.5) * (b[0] - a[0]);
        faces.length += edge.length / 2;
      }
    }
    std::vector<int> named(mesh_.units.size(), 0);
    for (VertexIndex v = 0; v < mesh_.vertices.size(); ++v)
      for (const UnitIndex unit : mesh_.vertices[v].units) {
        ++named[unit];
        if (mesh_.units[unit].vertex != v) note("unit {} belongs to another vertex than {}", unit, v);
      }
    for (UnitIndex k = 0; k < mesh_.units.size(); ++k) {
      const ContactUnit& unit = mesh_.units[k];
      if (named[k] != 1) note("unit {} is named by {} vertices", k, named[k]);
      if (unit.line >= mesh_.lines.size()) note("unit {} is of no line", k);
      const auto found = expected.find(std::minmax(unit.minus, unit.plus));
      if (found == expected.end()) {
        note("unit {} has nodes that no fracture edge parts", k);
        continue;
      }
      const double sign = unit.minus < unit.plus ? 1 : -1;
      const Faces& faces = found->second;
      if (std::hypot(unit.face[0] - sign * faces.face[0], unit.face[1] - sign * faces.face[1]) >
              same_length ||
          std::abs(unit.length - faces.length) > same_length)
        note("unit {} has the face ({}, {}) and the length {}", k, unit.face[0], unit.face[1], unit.length);
      expected.erase(found);
    }
    if (!expected.empty()) note("{} pairs of faces have no unit", expected.size());
  }

  void inspect_sides() {
    std::set<NodeIndex> used;
    std::array<std::set<NodeIndex>, 4> on;
    for (const auto& [at, nodes] : nodes_at_) {
      used.insert(nodes.begin(), nodes.end());
      const std::array<bool, 4> here{at[0] == -domain_.width / 2, at[0] == domain_.width / 2,
                                     at[1] == -domain_.height / 2, at[1] == domain_.height / 2};
      for (std::size_t side = 0; side < 4; ++side)
        if (here[side]) on[side].insert(nodes.begin(), nodes.end());
    }
    for (std::size_t side = 0; side < 4; ++side) {
      const std::set<NodeIndex> listed(mesh_.side_nodes[side].begin(), mesh_.side_nodes[side].end());
      if (listed != on[side] || listed.size() != mesh_.side_nodes[side].size())
        note("the nodes of side {} are not those there", side);
    }
    std::vector<NodeIndex> unused;
    for (NodeIndex node = 0; node < mesh_.position.size(); ++node)
      if (!used.contains(node)) unused.push_back(node);
    if (unused != mesh_.unused_nodes)
      note("{} places have no node, {} are listed", unused.size(), mesh_.unused_nodes.size());
  }

  const Mesh& mesh_;
  const Domain& domain_;
  std::map<Point, std::set<NodeIndex>> nodes_at_;
  std::map<std::pair<Point, Point>, ElementIndex> left_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> mesh_faults(const Mesh& mesh, const Domain& domain) {
  return Inspection(mesh, domain).faults();
}

}  // namespace fissura::structure::fakes
