// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/wedges.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "common/errors.hpp"

namespace fissura::structure {

namespace {

constexpr double probe_depth = 0.02;  // of the way from a corner to the middle of its triangle

/// Name of a place: a fracture vertex, a node without one, or a new point.
using Place = std::uint64_t;
constexpr Place vertex_place = Place{1} << 40, node_place = Place{2} << 40, point_place = Place{3} << 40;

class WedgeFinder {
 public:
  explicit WedgeFinder(const WedgeInput& input) : input_(input), vertex_of_node_(fracture_nodes(input.mesh)) {}

  WedgeNodes find() {
    name_points();
    list_patch_corners();
    list_outside_corners();
    list_cuts();
    join_corners();
    number_wedges();
    give_sources();
    return std::move(result_);
  }

 private:
  void name_points() {
    const auto& patch = input_.patch;
    place_of_point_.resize(patch.points.size());
    for (std::uint32_t p = 0; p < patch.points.size(); ++p) {
      place_of_point_[p] = point_place | p;
      if (p < input_.outline.fixed) place_of_point_[p] = place_of_node(input_.outline.node[p]);
    }
    for (const LinePoint& at : input_.line) place_of_point_[at.point] = vertex_place | at.vertex;
    for (std::uint32_t p = 0; p < patch.fixed; ++p)
      if ((place_of_point_[p] & ~Place{0xffffffffu}) == vertex_place) special_.emplace(place_of_point_[p], p);
    for (const LinePoint& at : input_.line)
      if (at.point < input_.outline.fixed) node_on_line_.emplace(input_.outline.node[at.point], place_of_point_[at.point]);
  }

  [[nodiscard]] Place place_of_node(NodeIndex node) const {
    if (const auto line = node_on_line_.find(node); line != node_on_line_.end()) return line->second;
    const auto vertex = vertex_of_node_.find(node);
    return vertex != vertex_of_node_.end() ? vertex_place | vertex->second : node_place | node;
  }

  static std::optional<VertexIndex> vertex_at(Place place) {
    if ((place & ~Place{0xffffffffu}) != vertex_place) return std::nullopt;
    return static_cast<VertexIndex>(place);
  }

  void add_corner(const std::array<Place, 3>& places, bool outside, std::uint32_t element, int k) {
    const Place here = places[k], next = places[(k + 1) % 3], last = places[(k + 2) % 3];
    if (!special_.contains(here)) return;
    result_.corners.push_back({outside, element, k, 0, vertex_at(here), vertex_at(next), vertex_at(last)});
    place_of_corner_.push_back({here, next, last});
  }

  void list_patch_corners() {
    for (std::uint32_t t = 0; t < input_.patch.triangles.size(); ++t) {
      const PointTriple& corners = input_.patch.triangles[t];
      const std::array<Place, 3> places{place_of_point_[corners[0]], place_of_point_[corners[1]], place_of_point_[corners[2]]};
      for (int k = 0; k < 3; ++k) add_corner(places, false, t, k);
    }
  }

  [[nodiscard]] std::vector<NodeIndex> nodes_at(std::uint32_t point) const {
    if (point >= input_.outline.fixed) return {};
    std::set<NodeIndex> nodes{input_.outline.node[point]};
    if (const auto vertex = vertex_of_node_.find(input_.outline.node[point]); vertex != vertex_of_node_.end())
      for (const UnitIndex unit : input_.mesh.vertices[vertex->second].units)
        nodes.insert({input_.mesh.units[unit].minus, input_.mesh.units[unit].plus});
    return {nodes.begin(), nodes.end()};
  }

  void list_outside_corners() {
    std::set<ElementIndex> outside;
    for (const auto& [place, point] : special_)
      for (const NodeIndex node : nodes_at(point))
        for (const ElementIndex element : input_.node_elements.of(node))
          if (!std::binary_search(input_.elements.begin(), input_.elements.end(), element)) outside.insert(element);
    for (const ElementIndex element : outside) {
      const auto& nodes = input_.mesh.elements[element];
      const std::array<Place, 3> places{place_of_node(nodes[0]), place_of_node(nodes[1]), place_of_node(nodes[2])};
      for (int k = 0; k < 3; ++k) add_corner(places, true, element, k);
    }
  }

  void list_cuts() {
    const auto cut = [&](const FractureEdge& edge) {
      cuts_.insert(std::minmax(vertex_place | edge.begin, vertex_place | edge.end));
    };
    for (const auto& [place, point] : special_)
      if (const auto vertex = vertex_at(place); vertex && *vertex < input_.mesh.vertices.size())
        for (const EdgeIndex edge : input_.mesh.vertices[*vertex].edges) cut(input_.mesh.edges[edge]);
    for (const FractureEdge& edge : input_.new_edges) cut(edge);
  }

  // Two corners at a place are neighbours if the edge between their elements leads there and is not cut.
  void join_corners() {
    parent_.resize(result_.corners.size());
    std::iota(parent_.begin(), parent_.end(), 0u);
    std::map<std::pair<Place, Place>, std::uint32_t> leaving;
    for (std::uint32_t c = 0; c < result_.corners.size(); ++c)
      leaving.emplace(std::pair{place_of_corner_[c][0], place_of_corner_[c][1]}, c);
    for (std::uint32_t c = 0; c < result_.corners.size(); ++c) {
      const Place here = place_of_corner_[c][0], last = place_of_corner_[c][2];
      if (cuts_.contains(std::minmax(here, last))) continue;
      if (const auto neighbour = leaving.find({here, last}); neighbour != leaving.end()) join(c, neighbour->second);
    }
  }

  void number_wedges() {
    std::map<std::uint32_t, std::uint32_t> wedge_of_root;
    for (std::uint32_t c = 0; c < result_.corners.size(); ++c) {
      const auto [found, is_new] = wedge_of_root.emplace(root(c), static_cast<std::uint32_t>(result_.wedges.size()));
      if (is_new) result_.wedges.push_back({special_.at(place_of_corner_[c][0]), std::nullopt, false, 0});
      result_.corners[c].wedge = found->second;
    }
  }

  void give_sources() {
    std::unordered_set<NodeIndex> taken;
    const auto give = [&](Wedge& wedge, NodeIndex node) {
      wedge.source = node;
      wedge.copies = !taken.insert(node).second;
    };
    for (const WedgeCorner& corner : result_.corners) {
      Wedge& wedge = result_.wedges[corner.wedge];
      if (!corner.outside) continue;
      const NodeIndex node = input_.mesh.elements[corner.element][corner.corner];
      if (!wedge.source) give(wedge, node);
      ENSURE(*wedge.source == node);
    }
    for (const WedgeCorner& corner : result_.corners) {
      Wedge& wedge = result_.wedges[corner.wedge];
      if (!wedge.source && wedge.point < input_.outline.fixed) give(wedge, node_inside(corner, wedge.point));
    }
  }

  /// The node at a point that the elements had which the corner's triangle covers.
  [[nodiscard]] NodeIndex node_inside(const WedgeCorner& corner, std::uint32_t point) const {
    const PointTriple& t = input_.patch.triangles[corner.element];
    const auto& points = input_.patch.points;
    Point probe = points[point];
    for (int axis = 0; axis < 2; ++axis)
      probe[axis] += probe_depth * ((points[t[0]][axis] + points[t[1]][axis] + points[t[2]][axis]) / 3 - probe[axis]);
    std::optional<NodeIndex> found;
    for (std::size_t k = 0; k < input_.elements.size() && !found; ++k) {
      if (!holds(input_.outline.triangles[k], probe)) continue;
      for (const NodeIndex node : input_.mesh.elements[input_.elements[k]])
        if (input_.outline.point_of_node.at(node) == point) found = node;
    }
    ENSURE(found.has_value());
    return *found;
  }

  std::uint32_t root(std::uint32_t c) {
    while (parent_[c] != c) c = parent_[c] = parent_[parent_[c]];
    return c;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  const WedgeInput& input_;
  std::unordered_map<NodeIndex, VertexIndex> vertex_of_node_;
  std::unordered_map<NodeIndex, Place> node_on_line_;
  std::vector<Place> place_of_point_;
  std::map<Place, std::uint32_t> special_;  // place -> point of the patch, of all places with wedges
  std::vector<std::array<Place, 3>> place_of_corner_;
  std::set<std::pair<Place, Place>> cuts_;
  std::vector<std::uint32_t> parent_;
  WedgeNodes result_;
};

}  // namespace

std::optional<std::uint32_t> WedgeNodes::node_left_of(VertexIndex vertex, VertexIndex other) const {
  for (const WedgeCorner& corner : corners)
    if (corner.vertex == vertex && corner.next == other) return wedges[corner.wedge].node;
  return std::nullopt;
}

std::optional<std::uint32_t> WedgeNodes::node_right_of(VertexIndex vertex, VertexIndex other) const {
  for (const WedgeCorner& corner : corners)
    if (corner.vertex == vertex && corner.last == other) return wedges[corner.wedge].node;
  return std::nullopt;
}

WedgeNodes assign_wedges(const WedgeInput& input) { return WedgeFinder(input).find(); }

}  // namespace fissura::structure
