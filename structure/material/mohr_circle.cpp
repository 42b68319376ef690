// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/material/mohr_circle.hpp"

#include <cmath>

namespace fissura::structure {

Principal principal(const InPlane<double>& stress) {
  const double centre = mohr_centre(stress);
  const double radius = std::sqrt(mohr_radius_squared(stress));
  if (radius == 0) return {centre, centre, {1, 0}};
  const double angle = 0.5 * std::atan2(stress.xy, 0.5 * (stress.xx - stress.yy));
  return {centre + radius, centre - radius, {std::cos(angle), std::sin(angle)}};
}

InPlane<double> tensile_part(const InPlane<double>& stress) {
  const double centre = mohr_centre(stress);
  const double radius = std::sqrt(mohr_radius_squared(stress));
  if (centre + radius <= 0) return {0, 0, 0};
  if (centre - radius >= 0) return stress;
  // n n = (I + deviator / radius) / 2 for the major direction n
  const double major = centre + radius;
  const double tilt = 0.5 * (stress.xx - stress.yy) / radius;
  return {0.5 * major * (1 + tilt), 0.5 * major * (1 - tilt), 0.5 * major * stress.xy / radius};
}

}  // namespace fissura::structure
