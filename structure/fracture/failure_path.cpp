// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/failure_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "structure/fracture/connected_elements.hpp"
#include "structure/fracture/tip_stress.hpp"

namespace fissura::structure {

namespace {

// In units of tip_size.
constexpr double stride = 0.5;
constexpr double disc_radius = 3, disc_width = 1.5;
constexpr double reach = 8;
constexpr double beside = 0.9;
constexpr double not_looked_at = 1;
constexpr int longest_path = 4;

constexpr double later_turn_limit = 0.4363323129985824;  // [rad], 25 degrees

double turn(const std::array<double, 2>& from, const std::array<double, 2>& to) {
  return std::atan2(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
}

std::vector<NodeIndex> nodes_of(const Mesh& mesh, const std::vector<ElementIndex>& elements) {
  std::vector<NodeIndex> nodes;
  for (const ElementIndex element : elements)
    nodes.insert(nodes.end(), mesh.elements[element].begin(), mesh.elements[element].end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

NodeIndex nearest_node(const Mesh& mesh, const std::vector<NodeIndex>& nodes, const Point& at) {
  double least = std::numeric_limits<double>::infinity();
  NodeIndex nearest = nodes.front();
  for (const NodeIndex node : nodes) {
    const double dx = mesh.position[node][0] - at[0], dy = mesh.position[node][1] - at[1];
    const double squared = dx * dx + dy * dy;
    if (squared >= least) continue;
    least = squared;
    nearest = node;
  }
  return nearest;
}

bool inside(const Domain& domain, const Point& at) {
  return std::abs(at[0]) < domain.width / 2 && std::abs(at[1]) < domain.height / 2;
}

bool is_end_of_line(const SegmentEnd& end) {
  return end.kind != SegmentEnd::Kind::rock;
}

}  // namespace

std::vector<Point> march(const RockNow& rock, const MarchStart& start, int steps) {
  const auto& [model, geometry, state] = rock;
  const double h = model.run_case.mesh.tip_size, turn_limit = model.run_case.growth.turn_limit;
  const std::vector<NodeIndex> nodes = nodes_of(
      geometry.mesh,
      connected_elements(geometry.mesh, geometry.node_elements, start.node, start.position, reach * h));
  std::vector<Point> points{start.position};
  std::array<double, 2> direction = start.direction;
  NodeIndex node = start.node;
  for (int k = 0; k < steps; ++k) {
    const Point& here = points.back();
    const auto stress = average_stress(
        geometry.mesh, geometry.node_elements, geometry.body, model.moduli, state.body.displacement,
        {here, node, direction, disc_radius * h, disc_width * h, HalfDisc::Weighting::ahead});
    const auto wanted =
        growth_direction(stress, direction, k == 0 ? turn_limit : std::min(turn_limit, later_turn_limit));
    if (std::abs(turn(start.direction, wanted)) <= turn_limit) direction = wanted;
    const Point next{here[0] + stride * h * direction[0], here[1] + stride * h * direction[1]};
    if (!inside(model.run_case.domain, next)) break;
    points.push_back(next);
    node = nearest_node(geometry.mesh, nodes, next);
  }
  return points;
}

std::optional<std::vector<SegmentEnd>> failure_path(const RockNow& rock, const FailureMap& map,
                                                    const FractureTip& tip) {
  const StructureModel& model = rock.model;
  const Geometry& geometry = rock.geometry;
  const Growth& growth = model.run_case.growth;
  const double h = model.run_case.mesh.tip_size;
  const auto near =
      connected_elements(geometry.mesh, geometry.node_elements, tip.node, tip.position, reach * h);
  const auto failed = [&](const Point& at) {
    return map.greatest_near(geometry.mesh, near, at, beside * h) >= growth.failure_damage;
  };
  if (std::none_of(near.begin(), near.end(),
                   [&](ElementIndex element) { return map.lost(element) >= growth.failure_damage; }))
    return std::nullopt;
  constexpr int per_segment = static_cast<int>(1 / stride);
  const std::vector<Point> points =
      march(rock, {tip.position, tip.node, tip.direction}, longest_path * per_segment);

  std::vector<SegmentEnd> ends;
  FractureTip here = tip;
  for (std::size_t k = per_segment; k < points.size() + per_segment; k += per_segment) {
    const Point& to = points[std::min(k, points.size() - 1)];
    const double length = std::hypot(to[0] - here.position[0], to[1] - here.position[1]);
    if (length == 0) break;
    const std::array<double, 2> direction{(to[0] - here.position[0]) / length,
                                          (to[1] - here.position[1]) / length};
    const NextSegment next = next_segment(geometry.mesh, model.run_case.domain, here, direction, h, h);
    if (!next.end) break;
    const bool last = is_end_of_line(*next.end);
    const Point middle{(here.position[0] + next.end->position[0]) / 2,
                       (here.position[1] + next.end->position[1]) / 2};
    const bool looked_at = last || static_cast<double>(k) * stride > not_looked_at;
    if (looked_at && (!failed(middle) || (!last && !failed(next.end->position)))) break;
    ends.push_back(*next.end);
    if (last || ends.size() == longest_path) break;
    here.position = next.end->position;
    here.direction = direction;
  }
  if (ends.empty()) return std::nullopt;
  if (!is_end_of_line(ends.back()) && static_cast<double>(ends.size()) < growth.failure_length)
    return std::nullopt;
  return ends;
}

}  // namespace fissura::structure
