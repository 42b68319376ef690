// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/material/crack_band.hpp"

#include <algorithm>

namespace fissura::structure {

double crack_band_length(const std::array<std::array<double, 2>, 3>& corner,
                         const std::array<double, 2>& normal) {
  const auto height = [&normal](const std::array<double, 2>& point) {
    return point[0] * normal[0] + point[1] * normal[1];
  };
  const auto [lowest, highest] = std::minmax({height(corner[0]), height(corner[1]), height(corner[2])});
  return highest - lowest;
}

}  // namespace fissura::structure
