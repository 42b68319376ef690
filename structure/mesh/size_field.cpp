// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/size_field.hpp"

#include <algorithm>

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

}  // namespace

SizeField::SizeField(const MeshControls& controls, std::span<const SizedSegment> lines)
    : controls_(controls), lines_(unweighted(lines)), short_stretches_(short_ones(controls, lines)) {}

SizeField::Sample SizeField::sample(Point point) const {
  const double distance = lines_.nearest(point).distance;
  const double beyond = std::max(0.0, distance - controls_.corridor);
  const double graded = std::min(controls_.far_size, controls_.fracture_size + controls_.gradation * beyond);
  return {std::min(graded, short_stretch_growth * short_stretches_.nearest(point).distance), distance};
}

double SizeField::size(Point point) const {
  return sample(point).size;
}

}  // namespace fissura::structure
