// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "structure/material/mohr_circle.hpp"

/// Failure surfaces as a limit on the radius r of Mohr's circle in the plane, given its centre c, so that a
/// stress can be tested without a square root. Effective stresses, tension positive [Pa]. `Real` is double or
/// a vector of them.
namespace fissura::structure {

/// Rankine:  c + r <= f_t.  Cracks open in the plane only: plane strain lets none open across it.
struct RankineSurface {
  double tensile_strength = 0;  ///< f_t [Pa]

  /// Greatest radius allowed; negative if none is [Pa].
  template <class Real>
  constexpr Real radius_limit(const Real& centre) const {
    return tensile_strength - centre;
  }
};

/// Mohr-Coulomb:  (s_1 - s_3) + (s_1 + s_3) sin(phi) <= 2 cohesion cos(phi)  with s_1 >= s_2 >= s_3, where
/// s_1 and s_3 are both in the plane, or one of them is the out-of-plane stress (de Souza Neto, Peric & Owen
/// 2008, ch. 6).
struct MohrCoulombSurface {
  double cohesion = 0;         ///< [Pa]
  double sine_friction = 0;    ///< sin(phi), 0 <= sin(phi) < 1
  double cosine_friction = 1;  ///< cos(phi)

  /// Greatest radius allowed; negative if none is [Pa].
  template <class Real>
  constexpr Real radius_limit(const Real& centre, const Real& out_of_plane) const {
    const double shear_strength = cohesion * cosine_friction;
    const Real in_plane = shear_strength - centre * sine_friction;
    const Real tilt = sine_friction * (centre + out_of_plane);
    const Real minor_out = (2 * shear_strength - (centre - out_of_plane) - tilt) / (1 + sine_friction);
    const Real major_out = (2 * shear_strength - (out_of_plane - centre) - tilt) / (1 - sine_friction);
    const Real least_out = minor_out < major_out ? minor_out : major_out;
    return in_plane < least_out ? in_plane : least_out;
  }
};

/// True where a circle of this squared radius [Pa2] is larger than the limit [Pa]. A vector gives a vector of
/// masks.
template <class Real>
constexpr auto exceeds(const Real& radius_squared, const Real& radius_limit) {
  return (radius_limit < 0.0) | (radius_squared > radius_limit * radius_limit);
}

}  // namespace fissura::structure
