// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/triangle_shape.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::structure {

TriangleShape shape(Point a, Point b, Point c) {
  double edge[3] = {std::hypot(c[0] - b[0], c[1] - b[1]), std::hypot(a[0] - c[0], a[1] - c[1]),
                    std::hypot(b[0] - a[0], b[1] - a[1])};
  std::sort(edge, edge + 3);
  const double area = twice_area(a, b, c);
  return {area / (edge[1] * edge[2]), area / edge[2], edge[0], edge[2]};
}

Point circumcentre(Point a, Point b, Point c) {
  const double bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0], cy = c[1] - a[1];
  const double divisor = 2 * (bx * cy - by * cx);
  const double bb = bx * bx + by * by, cc = cx * cx + cy * cy;
  return {a[0] + (cy * bb - by * cc) / divisor, a[1] + (bx * cc - cx * bb) / divisor};
}

}  // namespace fissura::structure
