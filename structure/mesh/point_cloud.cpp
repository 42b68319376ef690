// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/point_cloud.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::structure {
namespace {

std::int64_t cell(double coordinate, double width) {
  return static_cast<std::int64_t>(std::floor(coordinate / width));
}

std::uint64_t key(std::int64_t i, std::int64_t j) {
  return (static_cast<std::uint64_t>(i) << 32) ^ (static_cast<std::uint64_t>(j) & 0xffffffffu);
}

}  // namespace

void OccupancyGrid::add(Point point, double spacing) {
  const int octave = std::ilogb(spacing);
  Cells& cells = octaves_[octave];
  cells.width = std::scalbn(1.0, octave);
  cells.content[key(cell(point[0], cells.width), cell(point[1], cells.width))].push_back(point);
}

double OccupancyGrid::nearest(Point point, double radius, double finest) const {
  double smallest = radius;
  for (auto octave = octaves_.lower_bound(std::ilogb(finest)); octave != octaves_.end(); ++octave) {
    const Cells& cells = octave->second;
    for (std::int64_t i = cell(point[0] - smallest, cells.width); i <= cell(point[0] + smallest, cells.width);
         ++i)
      for (std::int64_t j = cell(point[1] - smallest, cells.width);
           j <= cell(point[1] + smallest, cells.width); ++j)
        if (const auto found = cells.content.find(key(i, j)); found != cells.content.end())
          for (const Point& other : found->second)
            smallest = std::min(smallest, std::hypot(other[0] - point[0], other[1] - point[1]));
  }
  return smallest;
}

}  // namespace fissura::structure
