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

/// Part of the stress carried by its tensile principal values,  s+ = sum of <s_i> n_i n_i  [Pa]. With the
/// deviator d (of the plane) and n n = (I + d / r) / 2 for the major, (I - d / r) / 2 for the minor direction
///   s+ = (<s_1> + <s_2>) / 2 I + (<s_1> - <s_2>) / (2 r) d .
/// Centre and radius are those of the stress's circle [Pa].
template <class Real>
constexpr InPlane<Real> tensile_part(const InPlane<Real>& stress, const Real& centre, const Real& radius) {
  const Real zero{}, major = centre + radius, minor = centre - radius;
  const Real tensile_major = major > 0.0 ? major : zero, tensile_minor = minor > 0.0 ? minor : zero;
  const Real mean = 0.5 * (tensile_major + tensile_minor);
  const Real half_difference = 0.5 * (tensile_major - tensile_minor);
  const Real share = radius > 0.0 ? half_difference / radius : zero;
  const Real deviator = share * (0.5 * (stress.xx - stress.yy));
  return {mean + deviator, mean - deviator, share * stress.xy};
}

InPlane<double> tensile_part(const InPlane<double>& stress);

}  // namespace fissura::structure
