// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/line_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/errors.hpp"
#include "structure/mesh/segment_tree.hpp"

namespace fissura::structure {
namespace {

std::string quoted(const Case& given, std::uint32_t line) {
  return fmt::format("'{}'", given.fractures[line].name);
}

struct Ray {
  double angle = 0;  // from the x axis [degrees]
  std::string owner;
};

double degrees(double x, double y) {
  return std::atan2(y, x) * 180 / std::numbers::pi;
}

void add_sides(std::vector<Ray>& rays, Point vertex, const Domain& domain) {
  if (std::abs(vertex[0]) == domain.width / 2) {
    rays.push_back({90, "a side of the domain"});
    rays.push_back({-90, "a side of the domain"});
  }
  if (std::abs(vertex[1]) == domain.height / 2) {
    rays.push_back({0, "a side of the domain"});
    rays.push_back({180, "a side of the domain"});
  }
}

}  // namespace

std::string text(Point point) {
  return fmt::format("({:.6g}, {:.6g}) m", point[0], point[1]);
}

void check_gaps(const LineArrangement& lines, const Case& given) {
  const double gap = smallest_gap * given.mesh.fracture_size;
  const double half[2] = {given.domain.width / 2, given.domain.height / 2};
  std::vector<WeightedSegment> segments;
  std::vector<std::uint32_t> line_of(lines.vertices.size());
  for (const LinePiece& piece : lines.pieces) {
    const Point begin = lines.vertices[piece.begin], end = lines.vertices[piece.end];
    segments.push_back({begin, end, 0});
    line_of[piece.begin] = line_of[piece.end] = piece.line;
    if (const double length = std::hypot(end[0] - begin[0], end[1] - begin[1]); length < gap)
      throw InputError(fmt::format(
          "fracture {} has two points (ends, bends or crossings) only {:.3g} m apart at {}: merge "
          "them, or keep {:.3g} m ({} of mesh.fracture_size) between them",
          quoted(given, piece.line), length, text(begin), gap, smallest_gap));
  }
  const SegmentTree tree(std::move(segments));
  for (std::uint32_t v = 0; v < lines.vertices.size(); ++v) {
    const Point point = lines.vertices[v];
    for (int k : {0, 1})
      if (const double distance = half[k] - std::abs(point[k]); distance > 0 && distance < gap)
        throw InputError(fmt::format(
            "fracture {} comes within {:.3g} m of a side of the domain at {}: let it end on the side, "
            "or keep {:.3g} m ({} of mesh.fracture_size) away",
            quoted(given, line_of[v]), distance, text(point), gap, smallest_gap));
    for (const std::uint32_t s : tree.within(point, gap)) {
      const LinePiece& piece = lines.pieces[s];
      if (piece.begin == v || piece.end == v) continue;
      const double distance =
          distance_to_segment(point, lines.vertices[piece.begin], lines.vertices[piece.end]);
      throw InputError(fmt::format(
          "fracture {} comes within {:.3g} m of fracture {} at {} without meeting it: join them, or "
          "keep {:.3g} m ({} of mesh.fracture_size) between them",
          quoted(given, line_of[v]), distance, quoted(given, piece.line), text(point), gap, smallest_gap));
    }
  }
}

void check_angles(const LineArrangement& lines, const Case& given) {
  std::vector<std::vector<Ray>> rays(lines.vertices.size());
  for (const LinePiece& piece : lines.pieces) {
    const Point begin = lines.vertices[piece.begin], end = lines.vertices[piece.end];
    const double x = end[0] - begin[0], y = end[1] - begin[1];
    rays[piece.begin].push_back({degrees(x, y), "fracture " + quoted(given, piece.line)});
    rays[piece.end].push_back({degrees(-x, -y), "fracture " + quoted(given, piece.line)});
  }
  for (std::size_t v = 0; v < rays.size(); ++v) {
    add_sides(rays[v], lines.vertices[v], given.domain);
    std::sort(rays[v].begin(), rays[v].end(), [](const Ray& a, const Ray& b) {
      return a.angle != b.angle ? a.angle < b.angle : a.owner < b.owner;
    });
    for (std::size_t i = 0; i < rays[v].size(); ++i) {
      const Ray& ray = rays[v][i];
      const Ray& next = rays[v][(i + 1) % rays[v].size()];
      const double angle = next.angle - ray.angle + (i + 1 == rays[v].size() ? 360 : 0);
      if (angle < smallest_line_angle)
        throw InputError(
            fmt::format("{} and {} meet at {:.3g} degrees at {}: the mesh needs at least {} degrees",
                        ray.owner, next.owner, angle, text(lines.vertices[v]), smallest_line_angle));
    }
  }
}

}  // namespace fissura::structure
