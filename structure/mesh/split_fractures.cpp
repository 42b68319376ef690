// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/split_fractures.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "common/errors.hpp"

namespace fissura::structure {
namespace {

struct CornersOfEdge {
  std::uint32_t begin = 0, end = 0;
};

std::uint64_t key(std::uint32_t begin, std::uint32_t end) {
  return (std::uint64_t{begin} << 32) | end;
}

class Splitter {
 public:
  Splitter(const PlanarMesh& planar, std::span<const FractureLine> lines) : planar_(planar), lines_(lines) {}

  Mesh split() {
    mesh_.position = planar_.points;
    mesh_.elements.assign(planar_.triangles.begin(), planar_.triangles.end());
    list_vertices_and_edges();
    list_corners();
    join_wedges();
    give_nodes_to_wedges();
    for (FractureEdge& edge : mesh_.edges) add_to_units(edge);
    return std::move(mesh_);
  }

 private:
  void list_vertices_and_edges() {
    vertex_of_point_.assign(planar_.points.size(), none);
    const auto vertex = [&](std::uint32_t point) {
      if (vertex_of_point_[point] == none) {
        vertex_of_point_[point] = static_cast<VertexIndex>(mesh_.vertices.size());
        mesh_.vertices.push_back({planar_.points[point], {}, point, {}});
      }
      return vertex_of_point_[point];
    };
    for (const LineEdge& edge : planar_.line_edges) {
      const Point a = planar_.points[edge.begin], b = planar_.points[edge.end];
      const VertexIndex begin = vertex(edge.begin), end = vertex(edge.end);
      add_edge(mesh_, {begin, end, edge.line, std::hypot(b[0] - a[0], b[1] - a[1])});
    }
  }

  // A corner is 3 * triangle + local point; only corners at line vertices matter.
  void list_corners() {
    wedge_.resize(3 * planar_.triangles.size());
    std::iota(wedge_.begin(), wedge_.end(), 0u);
    for (std::uint32_t t = 0; t < planar_.triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t begin = planar_.triangles[t][k], end = planar_.triangles[t][(k + 1) % 3];
        if (on_line(begin) || on_line(end)) left_of_[key(begin, end)] = {3 * t + k, 3 * t + (k + 1) % 3};
      }
    for (const LineEdge& edge : planar_.line_edges) {
      cut_.insert(key(edge.begin, edge.end));
      cut_.insert(key(edge.end, edge.begin));
    }
  }

  void join_wedges() {
    for (std::uint32_t t = 0; t < planar_.triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t begin = planar_.triangles[t][k], end = planar_.triangles[t][(k + 1) % 3];
        if ((!on_line(begin) && !on_line(end)) || cut_.contains(key(begin, end))) continue;
        const auto beyond = left_of_.find(key(end, begin));
        if (beyond == left_of_.end()) continue;
        join(3 * t + k, beyond->second.end);
        join(3 * t + (k + 1) % 3, beyond->second.begin);
      }
  }

  void give_nodes_to_wedges() {
    std::vector<char> taken(planar_.points.size(), 0);
    std::vector<NodeIndex> node_of_wedge(wedge_.size(), none);
    for (std::uint32_t corner = 0; corner < wedge_.size(); ++corner) {
      const std::uint32_t point = planar_.triangles[corner / 3][corner % 3];
      if (!on_line(point)) continue;
      NodeIndex& node = node_of_wedge[root(corner)];
      if (node == none && !taken[point]) {
        node = point;
        taken[point] = 1;
      } else if (node == none) {
        node = static_cast<NodeIndex>(mesh_.position.size());
        mesh_.position.push_back(planar_.points[point]);
      }
      mesh_.elements[corner / 3][corner % 3] = node;
    }
  }

  void add_to_units(FractureEdge& edge) {
    const std::uint32_t begin = mesh_.vertices[edge.begin].node, end = mesh_.vertices[edge.end].node;
    const auto left = left_of_.find(key(begin, end)), right = left_of_.find(key(end, begin));
    ENSURE(left != left_of_.end() && right != left_of_.end());
    edge.unit[0] = add_half(edge, edge.begin, node(right->second.end), node(left->second.begin));
    edge.unit[1] = add_half(edge, edge.end, node(right->second.begin), node(left->second.end));
  }

  UnitIndex add_half(const FractureEdge& edge, VertexIndex vertex, NodeIndex minus, NodeIndex plus) {
    if (minus == plus) return no_unit;
    const Point a = mesh_.vertices[edge.begin].position, b = mesh_.vertices[edge.end].position;
    const auto [found, is_new] = unit_of_pair_.try_emplace(std::minmax(minus, plus), mesh_.units.size());
    if (is_new) {
      mesh_.vertices[vertex].units.push_back(static_cast<UnitIndex>(mesh_.units.size()));
      mesh_.units.push_back({minus, plus, {0, 0}, 0, vertex, edge.line});
    }
    ContactUnit& unit = mesh_.units[found->second];
    const double half = unit.plus == plus ? 0.5 : -0.5;
    unit.face[0] -= half * (b[1] - a[1]);
    unit.face[1] += half * (b[0] - a[0]);
    unit.length += edge.length / 2;
    if (lines_[edge.line].tensile_strength > lines_[unit.line].tensile_strength) unit.line = edge.line;
    return static_cast<UnitIndex>(found->second);
  }

  [[nodiscard]] NodeIndex node(std::uint32_t corner) const { return mesh_.elements[corner / 3][corner % 3]; }
  [[nodiscard]] bool on_line(std::uint32_t point) const { return vertex_of_point_[point] != none; }

  std::uint32_t root(std::uint32_t corner) {
    while (wedge_[corner] != corner) corner = wedge_[corner] = wedge_[wedge_[corner]];
    return corner;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    wedge_[std::max(a, b)] = std::min(a, b);
  }

  static constexpr std::uint32_t none = 0xffffffffu;

  const PlanarMesh& planar_;
  std::span<const FractureLine> lines_;
  Mesh mesh_;
  std::vector<VertexIndex> vertex_of_point_;
  std::vector<std::uint32_t> wedge_;                          // union-find over corners
  std::unordered_map<std::uint64_t, CornersOfEdge> left_of_;  // corners at begin and end of a directed edge
  std::unordered_set<std::uint64_t> cut_;
  std::map<std::pair<NodeIndex, NodeIndex>, std::size_t> unit_of_pair_;
};

}  // namespace

Mesh split_fractures(const PlanarMesh& planar, std::span<const FractureLine> lines) {
  return Splitter(planar, lines).split();
}

}  // namespace fissura::structure
