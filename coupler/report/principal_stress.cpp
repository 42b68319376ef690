// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/principal_stress.hpp"

#include <cmath>
#include <numbers>

namespace fissura::coupler {

PrincipalStress principal_stress(double xx, double yy, double xy) {
  const double mean = (xx + yy) / 2, radius = std::hypot((xx - yy) / 2, xy);
  if (radius == 0) return {mean, mean, 0};
  double angle = std::atan2(2 * xy, xx - yy) / 2 + std::numbers::pi / 2;
  if (angle > std::numbers::pi / 2) angle -= std::numbers::pi;
  return {mean + radius, mean - radius, angle};
}

}  // namespace fissura::coupler
