// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/patch_plan.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <unordered_set>

#include "common/errors.hpp"
#include "structure/fracture/wedges.hpp"
#include "structure/mesh/triangle_shape.hpp"

namespace fissura::structure {

namespace {

PlannedNode interpolated(const Mesh& mesh, const std::vector<ElementIndex>& elements, const PatchOutline& outline,
                         const Point& at) {
  const std::size_t holder = triangle_around(outline.triangles, at);
  const auto& t = outline.triangles[holder];
  const double area = twice_area(t[0], t[1], t[2]);
  PlannedNode node;
  node.position = at;
  node.corner = mesh.elements[elements[holder]];
  node.weight = {twice_area(at, t[1], t[2]) / area, twice_area(t[0], at, t[2]) / area, twice_area(t[0], t[1], at) / area};
  return node;
}

double edge_length(const Point& a, const Point& b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }

class Planner {
 public:
  Planner(const PlanInput& input, const std::vector<LineVertex>& line, const std::vector<ElementIndex>& elements,
          const PatchOutline& outline, const PatchMesh& patch)
      : input_(input), line_(line), elements_(elements), outline_(outline), patch_(patch) {
    plan_.removed = elements;
    plan_.tip = line.back().position;
    plan_.smallest_angle = patch.smallest_angle;
    plan_.smallest_altitude = patch.smallest_altitude;
  }

  PatchPlan plan() {
    add_line();
    give_nodes_to_ordinary_points();
    WedgeNodes wedges = assign_wedges({input_.mesh, input_.node_elements, elements_, outline_, patch_, line_points_, plan_.new_edges});
    number_wedge_nodes(wedges);
    write_triangles(wedges);
    list_unused();
    list_units(wedges);
    return std::move(plan_);
  }

 private:
  [[nodiscard]] std::size_t nodes_before() const { return input_.mesh.position.size(); }

  PlannedNodeIndex add(const PlannedNode& node) {
    plan_.nodes.push_back(node);
    return static_cast<PlannedNodeIndex>(nodes_before() + plan_.nodes.size() - 1);
  }

  void add_line() {
    for (const LineVertex& point : line_) {
      VertexIndex vertex = static_cast<VertexIndex>(input_.vertices + plan_.new_vertices.size());
      if (point.vertex)
        vertex = *point.vertex;
      else
        plan_.new_vertices.push_back({point.position, {}, 0, {}});
      line_points_.push_back({point_at(point.position), vertex});
    }
    for (std::size_t k = 0; k + 1 < line_.size(); ++k)
      plan_.new_edges.push_back({line_points_[k].vertex, line_points_[k + 1].vertex, input_.line,
                                 edge_length(line_[k].position, line_[k + 1].position)});
  }

  [[nodiscard]] std::uint32_t point_at(const Point& at) const {
    for (std::uint32_t p = 0; p < patch_.fixed; ++p)
      if (patch_.points[p] == at) return p;
    ENSURE(!"a point of the line is a fixed point of the patch");
    return 0;
  }

  void give_nodes_to_ordinary_points() {
    node_of_point_.resize(patch_.points.size());
    for (std::uint32_t p = 0; p < outline_.fixed; ++p) node_of_point_[p] = outline_.node[p];
    for (std::size_t p = patch_.fixed; p < patch_.points.size(); ++p) {
      const std::uint32_t origin = patch_.outline_point[p - patch_.fixed];
      if (origin != PatchMesh::added && outline_.points[origin] == patch_.points[p])
        node_of_point_[p] = outline_.node[origin];
      else
        node_of_point_[p] = add(interpolated(input_.mesh, elements_, outline_, patch_.points[p]));
    }
  }

  void number_wedge_nodes(WedgeNodes& wedges) {
    for (Wedge& wedge : wedges.wedges) {
      if (!wedge.source) {
        wedge.node = add(interpolated(input_.mesh, elements_, outline_, patch_.points[wedge.point]));
      } else if (wedge.copies) {
        PlannedNode copy;
        copy.origin = PlannedNode::Origin::copy;
        copy.position = input_.mesh.position[*wedge.source];
        copy.source = *wedge.source;
        wedge.node = add(copy);
      } else {
        wedge.node = *wedge.source;
      }
    }
    for (const WedgeCorner& corner : wedges.corners)
      if (corner.outside)
        if (const PlannedNodeIndex node = wedges.wedges[corner.wedge].node;
            node != input_.mesh.elements[corner.element][corner.corner])
          plan_.rewired.push_back({corner.element, corner.corner, node});
    for (FractureVertex& vertex : plan_.new_vertices)
      for (const Wedge& wedge : wedges.wedges)
        if (patch_.points[wedge.point] == vertex.position) {
          vertex.node = wedge.node;
          break;
        }
  }

  void write_triangles(const WedgeNodes& wedges) {
    for (const PointTriple& t : patch_.triangles)
      plan_.made.push_back({node_of_point_[t[0]], node_of_point_[t[1]], node_of_point_[t[2]]});
    for (const WedgeCorner& corner : wedges.corners)
      if (!corner.outside) plan_.made[corner.element][corner.corner] = wedges.wedges[corner.wedge].node;
  }

  void list_unused() {
    std::unordered_set<PlannedNodeIndex> used;
    for (const auto& triangle : plan_.made) used.insert(triangle.begin(), triangle.end());
    std::set<NodeIndex> unused;
    for (std::size_t p = outline_.fixed; p < outline_.points.size(); ++p)
      if (!used.contains(outline_.node[p])) unused.insert(outline_.node[p]);
    plan_.unused.assign(unused.begin(), unused.end());
  }

  // Units of the vertices on the new line, from the corners to the left and right of every fracture edge there.
  void list_units(const WedgeNodes& wedges) {
    for (const LinePoint& line_point : line_points_) {
      std::vector<PlannedUnit> units;
      for (const EdgeIndex index : edges_at(line_point.vertex)) {
        const FractureEdge& edge = planned_edge(index);
        const bool at_begin = edge.begin == line_point.vertex;
        const VertexIndex other = at_begin ? edge.end : edge.begin;
        const auto left = wedges.node_left_of(line_point.vertex, other);
        const auto right = wedges.node_right_of(line_point.vertex, other);
        ENSURE(left && right);
        add_half(index, line_point.vertex, at_begin ? *right : *left, at_begin ? *left : *right, units);
      }
      if (units.empty()) continue;
      plan_.split.push_back(line_point.vertex);
      match_units(line_point.vertex, units);
      plan_.units.insert(plan_.units.end(), units.begin(), units.end());
    }
  }

  [[nodiscard]] std::vector<EdgeIndex> edges_at(VertexIndex vertex) const {
    std::vector<EdgeIndex> edges;
    if (vertex < input_.mesh.vertices.size()) edges = input_.mesh.vertices[vertex].edges;
    for (EdgeIndex k = 0; k < plan_.new_edges.size(); ++k)
      if (plan_.new_edges[k].begin == vertex || plan_.new_edges[k].end == vertex)
        edges.push_back(static_cast<EdgeIndex>(input_.mesh.edges.size()) + k);
    return edges;
  }

  [[nodiscard]] const FractureEdge& planned_edge(EdgeIndex index) const {
    const auto& existing = input_.mesh.edges;
    return index < existing.size() ? existing[index] : plan_.new_edges[index - existing.size()];
  }

  void add_half(EdgeIndex index, VertexIndex vertex, PlannedNodeIndex minus, PlannedNodeIndex plus,
                std::vector<PlannedUnit>& units) const {
    if (minus == plus) return;
    const FractureEdge& edge = planned_edge(index);
    const Point a = position(edge.begin), b = position(edge.end);
    auto same = std::find_if(units.begin(), units.end(), [&](const PlannedUnit& unit) {
      return std::minmax(unit.minus, unit.plus) == std::minmax(minus, plus);
    });
    if (same == units.end()) {
      units.push_back({minus, plus, {0, 0}, 0, vertex, edge.line, std::nullopt, std::nullopt, {}});
      same = units.end() - 1;
    }
    same->edge_ends.push_back({index, vertex == edge.begin ? 0 : 1});
    const double half = same->plus == plus ? 0.5 : -0.5;
    same->face[0] -= half * (b[1] - a[1]);
    same->face[1] += half * (b[0] - a[0]);
    same->length += edge.length / 2;
    const auto& lines = input_.mesh.lines;
    const auto strength = [&](std::uint32_t line) {
      return line < lines.size() ? lines[line].tensile_strength : std::numeric_limits<double>::infinity();
    };
    if (strength(edge.line) > strength(same->line)) same->line = edge.line;
  }

  void match_units(VertexIndex vertex, std::vector<PlannedUnit>& units) const {
    if (vertex >= input_.mesh.vertices.size()) return;
    std::vector<UnitIndex> left = input_.mesh.vertices[vertex].units;
    for (PlannedUnit& unit : units)
      for (const UnitIndex old : input_.mesh.vertices[vertex].units) {
        const ContactUnit& was = input_.mesh.units[old];
        const NodeIndex minus = source(unit.minus), plus = source(unit.plus);
        if (std::minmax(minus, plus) != std::minmax(was.minus, was.plus)) continue;
        unit.source = old;
        if (minus != was.minus) reverse(unit);
        if (const auto free = std::find(left.begin(), left.end(), old); free != left.end()) {
          unit.same = old;
          left.erase(free);
        }
      }
    ENSURE(left.empty());
  }

  static void reverse(PlannedUnit& unit) {
    std::swap(unit.minus, unit.plus);
    unit.face = {-unit.face[0], -unit.face[1]};
  }

  [[nodiscard]] NodeIndex source(PlannedNodeIndex node) const {
    if (node < nodes_before()) return node;
    return plan_.nodes[node - nodes_before()].source;
  }

  [[nodiscard]] Point position(VertexIndex vertex) const {
    if (vertex < input_.mesh.vertices.size()) return input_.mesh.vertices[vertex].position;
    return plan_.new_vertices[vertex - input_.vertices].position;
  }

  const PlanInput& input_;
  const std::vector<LineVertex>& line_;
  const std::vector<ElementIndex>& elements_;
  const PatchOutline& outline_;
  const PatchMesh& patch_;
  PatchPlan plan_;
  std::vector<LinePoint> line_points_;
  std::vector<PlannedNodeIndex> node_of_point_;
};

}  // namespace

PatchPlan plan_patch(const PlanInput& input, const std::vector<LineVertex>& line, const std::vector<ElementIndex>& elements,
                     const PatchOutline& outline, const PatchMesh& patch) {
  return Planner(input, line, elements, outline, patch).plan();
}

}  // namespace fissura::structure
