// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "common/seismicity/source_record.hpp"

namespace fissura::structure::fakes {

/// Eigenvalues of a moment tensor of plane strain, descending: those of Mohr's circle, and zz [N m].
inline std::array<double, 3> principal_values(const PlaneTensor& moment) {
  const auto [xx, yy, zz, xy] = moment;
  const double centre = (xx + yy) / 2, radius = std::hypot((xx - yy) / 2, xy);
  std::array<double, 3> values{centre + radius, centre - radius, zz};
  std::sort(values.begin(), values.end(), std::greater<>());
  return values;
}

}  // namespace fissura::structure::fakes
