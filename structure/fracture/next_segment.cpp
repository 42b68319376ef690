// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/next_segment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>
#include <vector>

#include "structure/mesh/segment_tree.hpp"
#include "structure/mesh/triangle_shape.hpp"

namespace fissura::structure {

namespace {

// In units of the element size at the tip.
constexpr double near_own = 0.6;
constexpr double near_other = 0.75;
constexpr double near_boundary = 1.2;
constexpr double longest_reach = 2.5;
constexpr double price_of_length = 0.2;       // against lateral distance, in the choice of a vertex to join
constexpr double least_angle_at_join = 0.35;  // [rad]
constexpr int edges_next_to_tip = 4;

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

bool cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  return (twice_area(a, b, c) > 0) != (twice_area(a, b, d) > 0) &&
         (twice_area(c, d, a) > 0) != (twice_area(c, d, b) > 0);
}

double segment_distance(const Point& a, const Point& b, const FractureEdge& edge, const Mesh& mesh) {
  const Point& c = mesh.vertices[edge.begin].position;
  const Point& d = mesh.vertices[edge.end].position;
  if (cross(a, b, c, d)) return 0;
  return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d), distance_to_segment(c, a, b),
                   distance_to_segment(d, a, b)});
}

/// Vertices within a few edges of a tip: its own end and, at a junction, the arms there.
std::unordered_set<VertexIndex> vertices_next_to(const Mesh& mesh, VertexIndex tip) {
  std::unordered_set<VertexIndex> near{tip};
  std::vector<VertexIndex> front{tip};
  for (int k = 0; k < edges_next_to_tip; ++k) {
    std::vector<VertexIndex> next;
    for (const VertexIndex vertex : front)
      for (const EdgeIndex edge : mesh.vertices[vertex].edges)
        if (const VertexIndex other = mesh.edges[edge].across(vertex); near.insert(other).second)
          next.push_back(other);
    front = std::move(next);
  }
  return near;
}

struct Aim {
  double lateral = 0, along = 0;  ///< of a point seen from the tip [m]

  [[nodiscard]] double cost() const { return lateral + price_of_length * along; }
};

Aim aim(const FractureTip& tip, const std::array<double, 2>& direction, const Point& at) {
  const double x = at[0] - tip.position[0], y = at[1] - tip.position[1];
  return {std::abs(direction[0] * y - direction[1] * x), direction[0] * x + direction[1] * y};
}

bool joins_at_fair_angle(const Mesh& mesh, const FractureTip& tip, VertexIndex vertex) {
  const Point& at = mesh.vertices[vertex].position;
  const double x = tip.position[0] - at[0], y = tip.position[1] - at[1];
  for (const FractureEdge& edge : mesh.edges) {
    if (edge.begin != vertex && edge.end != vertex) continue;
    const Point& other = mesh.vertices[edge.begin == vertex ? edge.end : edge.begin].position;
    const double ex = other[0] - at[0], ey = other[1] - at[1];
    if (std::acos(std::clamp((x * ex + y * ey) / (std::hypot(x, y) * std::hypot(ex, ey)), -1.0, 1.0)) <
        least_angle_at_join)
      return false;
  }
  return true;
}

std::optional<SegmentEnd> join(const Mesh& mesh, const FractureTip& tip,
                               const std::array<double, 2>& direction,
                               const std::unordered_set<VertexIndex>& own, double reach) {
  std::optional<SegmentEnd> best;
  double least = std::numeric_limits<double>::infinity();
  for (VertexIndex v = 0; v < mesh.vertices.size(); ++v) {
    const Point& at = mesh.vertices[v].position;
    if (own.contains(v) || distance(at, tip.position) > reach) continue;
    const Aim seen = aim(tip, direction, at);
    if (seen.along <= 0 || seen.cost() >= least || !joins_at_fair_angle(mesh, tip, v)) continue;
    least = seen.cost();
    best = SegmentEnd{SegmentEnd::Kind::fracture, at, v, 0};
  }
  return best;
}

double distance_inside(const Domain& domain, const Point& at) {
  return std::min(domain.width / 2 - std::abs(at[0]), domain.height / 2 - std::abs(at[1]));
}

std::optional<SegmentEnd> break_through(const Mesh& mesh, const Domain& domain, const FractureTip& tip,
                                        const std::array<double, 2>& direction, double reach) {
  std::optional<SegmentEnd> best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& side : mesh.side_nodes)
    for (const NodeIndex node : side) {
      const Point& at = mesh.position[node];
      const bool corner = std::abs(at[0]) == domain.width / 2 && std::abs(at[1]) == domain.height / 2;
      const Aim seen = aim(tip, direction, at);
      if (corner || seen.along <= 0 || distance(at, tip.position) > reach || seen.cost() >= least) continue;
      least = seen.cost();
      best = SegmentEnd{SegmentEnd::Kind::boundary, at, 0, node};
    }
  return best;
}

}  // namespace

std::array<double, 2> growth_direction(const InPlane<double>& stress, const std::array<double, 2>& before,
                                       double turn_limit) {
  const auto across = principal(stress).direction;
  std::array<double, 2> along{-across[1], across[0]};
  if (along[0] * before[0] + along[1] * before[1] < 0) along = {across[1], -across[0]};
  const double turn =
      std::atan2(before[0] * along[1] - before[1] * along[0], before[0] * along[0] + before[1] * along[1]);
  if (std::abs(turn) <= turn_limit) return along;
  const double c = std::cos(turn_limit), s = std::copysign(std::sin(turn_limit), turn);
  return {c * before[0] - s * before[1], s * before[0] + c * before[1]};
}

NextSegment next_segment(const Mesh& mesh, const Domain& domain, const FractureTip& tip,
                         const std::array<double, 2>& direction, double length, double h) {
  const Point end{tip.position[0] + length * direction[0], tip.position[1] + length * direction[1]};
  const std::unordered_set<VertexIndex> own = vertices_next_to(mesh, tip.vertex);
  bool meets_other = false, crosses_other = false;
  for (const FractureEdge& edge : mesh.edges) {
    if (edge.begin == tip.vertex || edge.end == tip.vertex) continue;
    const double gap = segment_distance(tip.position, end, edge, mesh);
    if (own.contains(edge.begin) && own.contains(edge.end)) {
      const Point &a = mesh.vertices[edge.begin].position, &b = mesh.vertices[edge.end].position;
      if (gap < near_own * h && gap < distance_to_segment(tip.position, a, b))
        return {std::nullopt, Obstacle::own_fracture};
      continue;
    }
    meets_other = meets_other || gap < near_other * h;
    crosses_other = crosses_other || gap == 0;
  }
  if (meets_other) {
    if (const auto joined = join(mesh, tip, direction, own, longest_reach * h)) return {joined, std::nullopt};
    if (crosses_other) return {std::nullopt, Obstacle::no_vertex_to_join};
  }
  if (distance_inside(domain, end) < near_boundary * h) {
    const auto through = break_through(mesh, domain, tip, direction, longest_reach * h);
    if (!through) return {std::nullopt, Obstacle::boundary_too_coarse};
    return {through, std::nullopt};
  }
  return {SegmentEnd{SegmentEnd::Kind::rock, end, 0, 0}, std::nullopt};
}

}  // namespace fissura::structure
