// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/natural_fractures/planar_segment.hpp"

#include <algorithm>
#include <cmath>

namespace fissura {

double length(Point vector) {
  return std::hypot(vector[0], vector[1]);
}

double length(const PlanarSegment& segment) {
  return length(difference(segment.end, segment.begin));
}

Point direction(const PlanarSegment& segment) {
  return scaled(difference(segment.end, segment.begin), 1 / length(segment));
}

double distance(Point point, const PlanarSegment& segment) {
  const Point along = difference(segment.end, segment.begin), to = difference(point, segment.begin);
  const double squared = dot(along, along);
  const double share = squared > 0 ? std::clamp(dot(to, along) / squared, 0.0, 1.0) : 0.0;
  return length(difference(to, scaled(along, share)));
}

double distance(const PlanarSegment& a, const PlanarSegment& b) {
  return std::min({distance(a.begin, b), distance(a.end, b), distance(b.begin, a), distance(b.end, a)});
}

std::optional<PlanarSegment> clipped(const PlanarSegment& segment, const Rectangle& rectangle) {
  const Point along = difference(segment.end, segment.begin);
  double first = 0, last = 1;
  const auto keep_below = [&](double rate, double room) {
    if (rate == 0) return room >= 0;
    if (rate > 0)
      last = std::min(last, room / rate);
    else
      first = std::max(first, room / rate);
    return true;
  };
  const bool inside = keep_below(-along[0], segment.begin[0] - rectangle.west) &&
                      keep_below(along[0], rectangle.east - segment.begin[0]) &&
                      keep_below(-along[1], segment.begin[1] - rectangle.south) &&
                      keep_below(along[1], rectangle.north - segment.begin[1]);
  if (!inside || !(first < last)) return {};
  return PlanarSegment{first > 0 ? sum(segment.begin, scaled(along, first)) : segment.begin,
                       last < 1 ? sum(segment.begin, scaled(along, last)) : segment.end};
}

}  // namespace fissura
