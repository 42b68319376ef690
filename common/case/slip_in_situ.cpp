// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/slip_in_situ.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::input {

namespace {

struct Traction {
  double normal;  ///< tension positive [Pa]
  double shear;   ///< [Pa]
};

Traction traction_on(const std::array<double, 3>& stress, const Point& a, const Point& b) {
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  const double nx = -(b[1] - a[1]) / length, ny = (b[0] - a[0]) / length;
  const double tx = stress[0] * nx + stress[2] * ny, ty = stress[2] * nx + stress[1] * ny;
  return {tx * nx + ty * ny, ty * nx - tx * ny};
}

/// Greatest excess of a line, negative if it holds [Pa].
double excess_of(const InSitu& in_situ, const FractureLine& line) {
  double greatest = -INFINITY;
  for (std::size_t j = 1; j < line.points.size(); ++j) {
    const Point &a = line.points[j - 1], &b = line.points[j];
    const Traction traction =
        traction_on(in_plane_stress(in_situ, {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}), a, b);
    const double strength =
        line.cohesion + line.tensile_strength - line.friction_coefficient * traction.normal;
    greatest = std::max(greatest, std::abs(traction.shear) - strength);
  }
  return greatest;
}

}  // namespace

std::optional<SlipInSitu> slip_in_situ(const Case& value) {
  SlipInSitu slip;
  for (std::size_t i = 0; i < value.fractures.size(); ++i) {
    if (value.fractures[i].kind != FractureKind::natural) continue;
    const double excess = excess_of(value.in_situ, value.fractures[i]);
    if (!(excess > 0)) continue;
    ++slip.lines;
    if (excess <= slip.excess) continue;
    slip.excess = excess;
    slip.worst = i;
  }
  if (slip.lines == 0) return std::nullopt;
  return slip;
}

}  // namespace fissura::input
