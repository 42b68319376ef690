// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/size_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "common/errors.hpp"

namespace fissura::structure {
namespace {

constexpr double short_stretch = 0.8;         // of the size along its line
constexpr double short_stretch_growth = 0.3;  // size per distance from a short stretch

std::vector<WeightedSegment> of_size(double size, std::span<const SizedSegment> lines) {
  std::vector<WeightedSegment> segments;
  for (const SizedSegment& line : lines)
    if (line.size == size) segments.push_back({line.begin, line.end, 0});
  return segments;
}

std::vector<WeightedSegment> short_ones(std::span<const SizedSegment> lines) {
  std::vector<WeightedSegment> segments;
  for (const SizedSegment& line : lines)
    if (line.edge_length < short_stretch * line.size)
      segments.push_back({line.begin, line.end, line.edge_length / short_stretch_growth});
  return segments;
}

double distance_to_rectangle(Point point, const Refinement& r) {
  return std::hypot(std::max({r.west - point[0], point[0] - r.east, 0.0}),
                    std::max({r.south - point[1], point[1] - r.north, 0.0}));
}

}  // namespace

double size_along(FractureKind kind, const MeshControls& controls) {
  return kind == FractureKind::natural && controls.natural_size > 0 ? controls.natural_size
                                                                    : controls.fracture_size;
}

SizeField::SizeField(const MeshControls& controls, std::span<const SizedSegment> lines,
                     std::vector<Point> tips)
    : controls_(controls), tips_(std::move(tips)), short_stretches_(short_ones(lines)) {
  ENSURE(tips_.empty() || controls.tip_size > 0);
  std::set<double> sizes;
  for (const SizedSegment& line : lines) sizes.insert(line.size);
  for (const double size : sizes) groups_.push_back({size, SegmentTree(of_size(size, lines))});
}

double SizeField::graded(double size, double distance) const {
  return size + controls_.gradation * std::max(0.0, distance - controls_.corridor);
}

SizeField::Sample SizeField::sample(Point point) const {
  Sample result{controls_.far_size, std::numeric_limits<double>::infinity()};
  for (const SizeGroup& group : groups_) {
    const double distance = group.lines.nearest(point).distance;
    result.distance = std::min(result.distance, distance);
    result.size = std::min(result.size, graded(group.size, distance));
  }
  const double short_limit = short_stretch_growth * short_stretches_.nearest(point).distance;
  result.size = refined(point, std::min(result.size, short_limit));
  return result;
}

double SizeField::size_on_line(Point point, double size) const {
  double least = size;
  for (const SizeGroup& group : groups_)
    if (group.size < size) least = std::min(least, graded(group.size, group.lines.nearest(point).distance));
  return refined(point, least);
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
