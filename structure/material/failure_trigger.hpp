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
};

/// The same as a limit, with what does not depend on the stress worked out beforehand.
class MohrCoulombLimit {
 public:
  explicit constexpr MohrCoulombLimit(const MohrCoulombSurface& surface)
      : sine_friction_(surface.sine_friction),
        shear_strength_(surface.cohesion * surface.cosine_friction),
        passive_((1 + surface.sine_friction) / (1 - surface.sine_friction)),
        active_(1 / passive_),
        compressive_strength_(2 * shear_strength_ / (1 - surface.sine_friction)),
        tensile_strength_(active_ * compressive_strength_) {}

  /// Greatest radius allowed; negative if none is [Pa].
  template <class Real>
  constexpr Real radius_limit(const Real& centre, const Real& out_of_plane) const {
    const Real in_plane = shear_strength_ - sine_friction_ * centre;
    const Real minor_out = (tensile_strength_ - centre) + active_ * out_of_plane;
    const Real major_out = (compressive_strength_ + centre) - passive_ * out_of_plane;
    const Real least_out = minor_out < major_out ? minor_out : major_out;
    return in_plane < least_out ? in_plane : least_out;
  }

 private:
  double sine_friction_, shear_strength_;           // [-], [Pa]
  double passive_, active_;                         // ratios of the principal stresses at failure [-]
  double compressive_strength_, tensile_strength_;  // unconfined [Pa]
};

/// True where a circle of this squared radius [Pa2] is larger than the limit [Pa]. A vector gives a vector of
/// masks.
template <class Real>
constexpr auto exceeds(const Real& radius_squared, const Real& radius_limit) {
  return (radius_limit < 0.0) | (radius_squared > radius_limit * radius_limit);
}

}  // namespace fissura::structure
