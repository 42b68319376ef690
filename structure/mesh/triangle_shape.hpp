// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "common/case/case.hpp"

namespace fissura::structure {

/// Twice the area of the triangle a b c, > 0 if it is counter-clockwise [m2].
inline double twice_area(Point a, Point b, Point c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Sizes of a triangle that decide how good an element it is.
struct TriangleShape {
  double sine_of_smallest_angle = 0;           ///< negative if the triangle is clockwise
  double smallest_altitude = 0;                ///< [m]
  double shortest_edge = 0, longest_edge = 0;  ///< [m]
};
TriangleShape shape(Point a, Point b, Point c);

/// Squares of two members of TriangleShape without any root, to about 1e-15; negative if the triangle is
/// clockwise. For a first look at many triangles.
struct SquaredShape {
  double sine_of_smallest_angle = 0;
  double smallest_altitude = 0;  ///< [m2]
};
inline SquaredShape squared_shape(Point a, Point b, Point c) {
  const auto square = [](Point p, Point q) {
    return (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]);
  };
  const double ab = square(a, b), bc = square(b, c), ca = square(c, a);
  const double longest = std::max({ab, bc, ca});
  const double middle = std::max(std::min(ab, bc), std::min(std::max(ab, bc), ca));
  const double area = twice_area(a, b, c), altitude = area * std::abs(area) / longest;
  return {altitude / middle, altitude};
}

/// Centre of the circle through a, b and c [m]; they must not lie on one line.
Point circumcentre(Point a, Point b, Point c);

}  // namespace fissura::structure
