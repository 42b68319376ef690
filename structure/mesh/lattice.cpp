// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fissura::structure {

std::vector<UniformPart> uniform_parts(const Case& given, std::span<const SizedSegment> lines) {
  const MeshControls& controls = given.mesh;
  const double x = given.domain.width / 2, y = given.domain.height / 2;
  std::vector<UniformPart> parts;
  for (const Refinement& r : controls.refinements)
    parts.push_back({r.size, r.west, r.east, r.south, r.north});
  for (const SizedSegment& line : lines)
    parts.push_back({line.size, std::min(line.begin[0], line.end[0]) - controls.corridor,
                     std::max(line.begin[0], line.end[0]) + controls.corridor,
                     std::min(line.begin[1], line.end[1]) - controls.corridor,
                     std::max(line.begin[1], line.end[1]) + controls.corridor});
  parts.push_back({controls.far_size, -x, x, -y, y});
  for (UniformPart& part : parts)
    part = {part.size, std::max(part.west, -x), std::min(part.east, x), std::max(part.south, -y),
            std::min(part.north, y)};
  return parts;
}

std::vector<Point> hexagonal_lattice(const UniformPart& part, double angle) {
  const double along[2] = {std::cos(angle), std::sin(angle)};
  const double row_height = part.size * std::numbers::sqrt3 / 2;
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  for (const double x : {part.west, part.east})
    for (const double y : {part.south, part.north}) {
      const double turned[2] = {along[0] * x + along[1] * y, -along[1] * x + along[0] * y};
      for (int axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], turned[axis]);
        high[axis] = std::max(high[axis], turned[axis]);
      }
    }
  std::vector<Point> points;
  const auto first_row = static_cast<long>(std::ceil(low[1] / row_height)),
             last_row = static_cast<long>(std::floor(high[1] / row_height));
  for (long row = first_row; row <= last_row; ++row) {
    const double across = static_cast<double>(row) * row_height;
    const double stagger = row % 2 == 0 ? 0 : part.size / 2;
    const auto first = static_cast<long>(std::ceil((low[0] - stagger) / part.size)),
               last = static_cast<long>(std::floor((high[0] - stagger) / part.size));
    for (long i = first; i <= last; ++i) {
      const double s = static_cast<double>(i) * part.size + stagger;
      const Point point{along[0] * s - along[1] * across, along[1] * s + along[0] * across};
      if (point[0] >= part.west && point[0] <= part.east && point[1] >= part.south && point[1] <= part.north)
        points.push_back(point);
    }
  }
  return points;
}

}  // namespace fissura::structure
