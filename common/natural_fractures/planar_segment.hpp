// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "common/case/case.hpp"

/// Points, vectors [m] and straight segments of the plane.
namespace fissura {

inline Point sum(Point a, Point b) {
  return {a[0] + b[0], a[1] + b[1]};
}
inline Point difference(Point a, Point b) {
  return {a[0] - b[0], a[1] - b[1]};
}
inline Point scaled(Point a, double factor) {
  return {factor * a[0], factor * a[1]};
}
inline double dot(Point a, Point b) {
  return a[0] * b[0] + a[1] * b[1];
}
/// Out-of-plane component of a x b.
inline double cross(Point a, Point b) {
  return a[0] * b[1] - a[1] * b[0];
}
double length(Point vector);

struct PlanarSegment {
  Point begin{}, end{};
};

double length(const PlanarSegment& segment);

/// Unit vector from begin to end. @pre the segment has a length
Point direction(const PlanarSegment& segment);

double distance(Point point, const PlanarSegment& segment);

/// Smallest distance between two segments that do not cross.
double distance(const PlanarSegment& a, const PlanarSegment& b);

/// An upright rectangle.
struct Rectangle {
  double west = 0, east = 0, south = 0, north = 0;
};

/// The part of a segment within a rectangle (Liang and Barsky 1984); nothing if no stretch of it is.
std::optional<PlanarSegment> clipped(const PlanarSegment& segment, const Rectangle& rectangle);

}  // namespace fissura
