// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "structure/mesh/mesh.hpp"

namespace fissura::structure {

/// Integral over a triangle of `area` [m2] of a function of the place, which may jump there: mean over the
/// centroids of the 16 equal triangles into which it is cut.
template <class Function>
double integral_over(const std::array<Point, 3>& corner, double area, const Function& function) {
  constexpr int divisions = 4;  // of an edge
  double sum = 0;
  const auto add = [&](double second, double third) {
    const double first = divisions - second - third;
    Point at{};
    for (std::size_t axis = 0; axis < 2; ++axis)
      at[axis] = (first * corner[0][axis] + second * corner[1][axis] + third * corner[2][axis]) / divisions;
    sum += function(at);
  };
  for (int i = 0; i < divisions; ++i)
    for (int j = 0; i + j < divisions; ++j) {
      add(i + 1.0 / 3, j + 1.0 / 3);
      if (i + j + 1 < divisions) add(i + 2.0 / 3, j + 2.0 / 3);
    }
  return sum * area / (divisions * divisions);
}

}  // namespace fissura::structure
