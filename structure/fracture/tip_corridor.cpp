// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/tip_corridor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "structure/dynamics/triangle.hpp"
#include "structure/fracture/connected_elements.hpp"
#include "structure/mesh/segment_tree.hpp"

namespace fissura::structure {

namespace {

// In units of tip_size.
constexpr double reach = 7;
constexpr double half_width = 0.7;
constexpr int march_steps = 12;
constexpr double straight_on = 2;

std::vector<Point> predicted_path(const RockNow& rock, const FractureTip& tip, double h) {
  std::vector<Point> path = march(rock, {tip.position, tip.node, tip.direction}, march_steps);
  const Point& end = path.back();
  std::array<double, 2> direction = tip.direction;
  if (path.size() > 1) {
    const Point& before = path[path.size() - 2];
    const double length = std::hypot(end[0] - before[0], end[1] - before[1]);
    direction = {(end[0] - before[0]) / length, (end[1] - before[1]) / length};
  }
  path.push_back({end[0] + straight_on * h * direction[0], end[1] + straight_on * h * direction[1]});
  return path;
}

double distance_to_path(const Point& at, const std::vector<Point>& path) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < path.size(); ++k)
    least = std::min(least, distance_to_segment(at, path[k], path[k + 1]));
  return least;
}

}  // namespace

TipCorridors tip_corridors(const RockNow& rock) {
  const Mesh& mesh = rock.geometry.mesh;
  const double h = rock.model.run_case.mesh.tip_size;
  std::vector<ElementIndex> near, allowed;
  for (const FractureTip& tip : fracture_tips(mesh)) {
    const std::vector<Point> path = predicted_path(rock, tip, h);
    for (const ElementIndex element :
         connected_elements(mesh, rock.geometry.node_elements, tip.node, tip.position, reach * h)) {
      near.push_back(element);
      if (distance_to_path(centroid(mesh, element), path) <= half_width * h) allowed.push_back(element);
    }
  }
  for (auto* list : {&near, &allowed}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  TipCorridors corridors;
  std::set_difference(near.begin(), near.end(), allowed.begin(), allowed.end(),
                      std::back_inserter(corridors.forbidden));
  return corridors;
}

}  // namespace fissura::structure
