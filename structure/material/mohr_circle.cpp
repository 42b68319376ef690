// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/material/mohr_circle.hpp"

#include <cmath>

namespace fissura::structure {

Principal principal(const InPlane<double>& stress) {
  const double centre = mohr_centre(stress), radius = std::sqrt(mohr_radius_squared(stress));
  if (radius == 0) return {centre, centre, {1, 0}};
  const double angle = 0.5 * std::atan2(stress.xy, 0.5 * (stress.xx - stress.yy));
  return {centre + radius, centre - radius, {std::cos(angle), std::sin(angle)}};
}

InPlane<double> tensile_part(const InPlane<double>& stress) {
  return tensile_part(stress, mohr_centre(stress), std::sqrt(mohr_radius_squared(stress)));
}

}  // namespace fissura::structure
