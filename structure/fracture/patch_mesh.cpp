// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/patch_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "common/errors.hpp"
#include "structure/fracture/patch_relaxation.hpp"
#include "structure/mesh/triangle_shape.hpp"

namespace fissura::structure {

namespace {

constexpr double cleared_beside_line = 0.6;  // of the target size
constexpr double same_area = 1e-9;

// Rows of points along the line and ahead of it, in units of their spacing unless said otherwise.
constexpr double row_height = std::numbers::sqrt3 / 2;
constexpr int rows_beside = 2, rows_behind = 3, rows_ahead = 2;
constexpr double row_reach = 1.9;
constexpr double nearest_to_row = 0.62;   // of the target size
constexpr double nearest_to_edge = 0.45;  // of the target size
constexpr double longest_spacing = 1.3;   // of the target size

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

bool crowds(const Point& point, const PatchProblem& problem, std::size_t first, std::size_t last, double distance) {
  for (std::size_t k = first; k < last; ++k)
    if (std::hypot(point[0] - problem.points[k][0], point[1] - problem.points[k][1]) < distance) return true;
  return false;
}

/// Points of staggered rows along the last stretch of the line and beyond its end, mirrored in it: the triangles there are as alike on both sides as
/// can be, so that they do not turn the next direction.
void add_rows(const std::vector<Point>& line, const PatchOutline& outline, const PatchSizeField& size, PatchProblem& problem) {
  const Point &from = line[line.size() - 2], &end = line.back();
  const double spacing = std::hypot(end[0] - from[0], end[1] - from[1]);
  const double tx = (end[0] - from[0]) / spacing, ty = (end[1] - from[1]) / spacing;
  if (spacing > longest_spacing * size.size(end)) return;
  const std::size_t fixed = problem.points.size();
  for (int row = 0; row <= rows_beside; ++row)
    for (int i = -rows_behind; i <= rows_ahead; ++i)
      for (const int side : {1, -1}) {
        if (row == 0 && (i <= 0 || side < 0)) continue;
        const double along = (i + (row % 2 == 0 ? 0 : 0.5)) * spacing, across = side * row * row_height * spacing;
        const Point point{end[0] + along * tx - across * ty, end[1] + along * ty + across * tx};
        if (distance_to_line(point, line) > row_reach * spacing) continue;
        const double h = size.size(point);
        if (crowds(point, problem, 0, fixed, nearest_to_row * h)) continue;
        const bool near_edge = std::any_of(problem.edges.begin(), problem.edges.end(), [&](const PointPair& edge) {
          return distance_to_segment(point, problem.points[edge[0]], problem.points[edge[1]]) < nearest_to_edge * h;
        });
        if (near_edge || !holds(outline.triangles[triangle_around(outline.triangles, point)], point)) continue;
        problem.points.push_back(point);
        problem.origin.push_back(PatchMesh::added);
      }
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
  add_rows(line, outline, size, problem);
  const std::size_t rows_end = problem.points.size();
  for (std::size_t k = outline.fixed; k < outline.points.size(); ++k) {
    const Point& point = outline.points[k];
    if (distance_to_line(point, line) < cleared_beside_line * size.size(point)) continue;
    if (crowds(point, problem, problem.fixed, rows_end, nearest_to_row * size.size(point))) continue;
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
