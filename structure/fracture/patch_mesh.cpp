// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/patch_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "common/errors.hpp"
#include "structure/fracture/patch_relaxation.hpp"
#include "structure/mesh/triangle_shape.hpp"

namespace fissura::structure {

namespace {

constexpr double cleared_beside_line = 0.6;  // of the target size
constexpr double same_area = 1e-9;

double area_of(const std::vector<std::array<Point, 3>>& triangles) {
  double area = 0;
  for (const auto& t : triangles) area += twice_area(t[0], t[1], t[2]) / 2;
  return area;
}

double distance_to_line(const Point& at, const std::vector<Point>& line) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < line.size(); ++k) least = std::min(least, distance_to_segment(at, line[k], line[k + 1]));
  return least;
}

std::uint32_t place_of(const PatchOutline& outline, const Point& at) {
  for (std::uint32_t k = 0; k < outline.fixed; ++k)
    if (outline.points[k] == at) return k;
  return PatchMesh::added;
}

/// Line points that are new, and the edges of the line in points of the problem to be.
void add_line(const PatchOutline& outline, const std::vector<Point>& line, PatchProblem& problem) {
  std::vector<std::uint32_t> places;
  for (const Point& point : line) {
    const std::uint32_t known = place_of(outline, point);
    if (known == PatchMesh::added) {
      places.push_back(static_cast<std::uint32_t>(problem.points.size()));
      problem.points.push_back(point);
    } else {
      places.push_back(known);
    }
  }
  for (std::size_t k = 0; k + 1 < places.size(); ++k) problem.edges.push_back({places[k], places[k + 1]});
}

bool inside(const PatchOutline& outline, const std::vector<Point>& line) {
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Point middle{(line[k][0] + line[k + 1][0]) / 2, (line[k][1] + line[k + 1][1]) / 2};
    if (!holds(outline.triangles[triangle_around(outline.triangles, middle)], middle)) return false;
  }
  for (const Point& point : line)
    if (place_of(outline, point) == PatchMesh::added &&
        !holds(outline.triangles[triangle_around(outline.triangles, point)], point))
      return false;
  return true;
}

}  // namespace

std::optional<PatchMesh> mesh_patch(const PatchOutline& outline, const std::vector<Point>& line, const TipSizeField& field,
                                    double least_altitude) {
  if (!inside(outline, line)) return std::nullopt;
  PatchProblem problem;
  problem.points.assign(outline.points.begin(), outline.points.begin() + static_cast<std::ptrdiff_t>(outline.fixed));
  problem.edges = outline.edges;
  add_line(outline, line, problem);
  problem.fixed = problem.points.size();
  problem.sides = outline.sides;
  std::vector<std::pair<Point, Point>> kept;
  for (const PointPair& edge : problem.edges) kept.emplace_back(problem.points[edge[0]], problem.points[edge[1]]);
  const PatchSizeField size(field, kept);
  problem.field = &size;
  for (std::size_t k = outline.fixed; k < outline.points.size(); ++k) {
    const Point& point = outline.points[k];
    if (distance_to_line(point, line) < cleared_beside_line * size.size(point)) continue;
    problem.origin.push_back(static_cast<std::uint32_t>(k));
    problem.points.push_back(point);
  }

  PatchMesh mesh;
  try {
    mesh.triangles = relax_patch(problem);
  } catch (const SolverError&) {
    return std::nullopt;  // a constraint that cannot be kept; the caller tries a larger patch
  }
  mesh.points = std::move(problem.points);
  mesh.fixed = problem.fixed;
  mesh.outline_point = std::move(problem.origin);

  double area = 0;
  mesh.smallest_angle = mesh.smallest_altitude = std::numeric_limits<double>::infinity();
  for (const PointTriple& t : mesh.triangles) {
    const Point &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const TriangleShape s = shape(a, b, c);
    area += twice_area(a, b, c) / 2;
    mesh.smallest_altitude = std::min(mesh.smallest_altitude, s.smallest_altitude);
    mesh.smallest_angle = std::min(mesh.smallest_angle, std::asin(std::clamp(s.sine_of_smallest_angle, -1.0, 1.0)));
  }
  const double expected = area_of(outline.triangles);
  if (std::abs(area - expected) > same_area * expected || mesh.smallest_altitude < least_altitude) return std::nullopt;
  return mesh;
}

}  // namespace fissura::structure
