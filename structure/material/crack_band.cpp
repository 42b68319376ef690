// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/material/crack_band.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::structure {

double crack_band_length(const std::array<std::array<double, 2>, 3>& corner,
                         const std::array<double, 2>& normal) {
  const auto& [a, b, c] = corner;
  const double double_area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  double centroid_height = 0;
  for (const auto& point : corner) centroid_height += (point[0] * normal[0] + point[1] * normal[1]) / 3;
  double slope = 0, longest_edge = 0;
  for (int i = 0; i < 3; ++i) {
    const auto& here = corner[i];
    const auto& next = corner[(i + 1) % 3];
    const auto& previous = corner[(i + 2) % 3];
    longest_edge = std::max(longest_edge, std::hypot(next[0] - here[0], next[1] - here[1]));
    if (here[0] * normal[0] + here[1] * normal[1] <= centroid_height) continue;
    slope += ((next[1] - previous[1]) * normal[0] + (previous[0] - next[0]) * normal[1]) / double_area;
  }
  return slope * longest_edge > 1 ? 1 / slope : longest_edge;
}

}  // namespace fissura::structure
