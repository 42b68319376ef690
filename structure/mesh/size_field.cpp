// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/size_field.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/errors.hpp"

namespace fissura::structure {
namespace {

constexpr double short_stretch = 0.8;         // of fracture_size
constexpr double short_stretch_growth = 0.3;  // size per distance from a short stretch

std::vector<WeightedSegment> unweighted(std::span<const SizedSegment> lines) {
  std::vector<WeightedSegment> segments;
  for (const SizedSegment& line : lines) segments.push_back({line.begin, line.end, 0});
  return segments;
}

std::vector<WeightedSegment> short_ones(const MeshControls& controls, std::span<const SizedSegment> lines) {
  std::vector<WeightedSegment> segments;
  for (const SizedSegment& line : lines)
    if (line.edge_length < short_stretch * controls.fracture_size)
      segments.push_back({line.begin, line.end, line.edge_length / short_stretch_growth});
  return segments;
}

double distance_to_rectangle(Point point, const Refinement& r) {
  return std::hypot(std::max({r.west - point[0], point[0] - r.east, 0.0}),
                    std::max({r.south - point[1], point[1] - r.north, 0.0}));
}

}  // namespace

SizeField::SizeField(const MeshControls& controls, std::span<const SizedSegment> lines,
                     std::vector<Point> tips)
    : controls_(controls),
      tips_(std::move(tips)),
      lines_(unweighted(lines)),
      short_stretches_(short_ones(controls, lines)) {
  ENSURE(tips_.empty() || controls.tip_size > 0);
}

SizeField::Sample SizeField::sample(Point point) const {
  const double distance = lines_.nearest(point).distance;
  const double beyond = std::max(0.0, distance - controls_.corridor);
  const double graded = std::min(controls_.far_size, controls_.fracture_size + controls_.gradation * beyond);
  const double short_limit = short_stretch_growth * short_stretches_.nearest(point).distance;
  return {refined(point, std::min(graded, short_limit)), distance};
}

double SizeField::size_on_line(Point point) const {
  return refined(point, controls_.fracture_size);
}

double SizeField::refined(Point point, double size) const {
  for (const Point& tip : tips_) {
    const double distance = std::hypot(point[0] - tip[0], point[1] - tip[1]);
    const double beyond = std::max(0.0, distance - controls_.tip_radius);
    size = std::min(size, controls_.tip_size + controls_.tip_gradation * beyond);
  }
  for (const Refinement& refinement : controls_.refinements)
    size = std::min(size, refinement.size + controls_.gradation * distance_to_rectangle(point, refinement));
  return size;
}

double SizeField::size(Point point) const {
  return sample(point).size;
}

}  // namespace fissura::structure
