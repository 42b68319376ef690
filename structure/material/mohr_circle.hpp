// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "structure/material/elasticity.hpp"

/// Mohr's circle of the in-plane stress, tension positive [Pa].
namespace fissura::structure {

/// Centre of the circle, (sigma_xx + sigma_yy) / 2 [Pa].
template <class Real>
constexpr Real mohr_centre(const InPlane<Real>& stress) {
  return 0.5 * (stress.xx + stress.yy);
}

/// Square of its radius, ((sigma_xx - sigma_yy) / 2)^2 + sigma_xy^2 [Pa2].
template <class Real>
constexpr Real mohr_radius_squared(const InPlane<Real>& stress) {
  const Real half_difference = 0.5 * (stress.xx - stress.yy);
  return half_difference * half_difference + stress.xy * stress.xy;
}

/// Principal stresses in the plane, major first [Pa], and the unit vector along the major one.
struct Principal {
  double major = 0, minor = 0;
  std::array<double, 2> direction{1, 0};
};

/// For an isotropic stress every direction is principal; x is taken.
Principal principal(const InPlane<double>& stress);

/// Part of the stress carried by its tensile principal values,  sum of <sigma_i> n_i n_i  [Pa].
InPlane<double> tensile_part(const InPlane<double>& stress);

}  // namespace fissura::structure
