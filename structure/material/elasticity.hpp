// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/case/case.hpp"

/// Isotropic linear elasticity in plane strain. Stresses are tension positive [Pa]; gamma_xy = 2 epsilon_xy.
namespace fissura::structure {

/// In-plane components of a stress [Pa] or, with `xy` = gamma_xy, of a strain [-]. `Real` is double or a
/// vector of them.
template <class Real>
struct InPlane {
  Real xx, yy, xy;
};

/// Stress in plane strain [Pa].
struct PlaneStrainStress {
  InPlane<double> in_plane{};
  double out_of_plane = 0;  ///< sigma_zz
};

/// Lame's constants [Pa].
struct Elasticity {
  double lame = 0;   ///< lambda
  double shear = 0;  ///< G
};

/// lambda = E nu / ((1 + nu)(1 - 2 nu)), G = E / (2 (1 + nu)).
constexpr Elasticity elasticity(double youngs_modulus, double poissons_ratio) {
  const double shear = youngs_modulus / (2 * (1 + poissons_ratio));
  return {2 * shear * poissons_ratio / (1 - 2 * poissons_ratio), shear};
}

inline Elasticity elasticity(const Rock& rock) {
  return elasticity(rock.youngs_modulus, rock.poissons_ratio);
}

/// In-plane stress of a strain:  sigma = lambda tr(eps) I + 2 G eps  [Pa].
template <class Real>
constexpr InPlane<Real> elastic_stress(const Elasticity& moduli, const InPlane<Real>& strain) {
  const Real mean = moduli.lame * (strain.xx + strain.yy);
  const double double_shear = 2 * moduli.shear;
  return {mean + double_shear * strain.xx, mean + double_shear * strain.yy, moduli.shear * strain.xy};
}

/// Out-of-plane stress of an in-plane strain:  sigma_zz = lambda (eps_xx + eps_yy)  [Pa].
constexpr double out_of_plane_stress(const Elasticity& moduli, const InPlane<double>& strain) {
  return moduli.lame * (strain.xx + strain.yy);
}

/// eps : C : eps / 2 of an in-plane strain  [J/m3].
constexpr double elastic_energy_density(const Elasticity& moduli, const InPlane<double>& strain) {
  const auto stress = elastic_stress(moduli, strain);
  return 0.5 * (stress.xx * strain.xx + stress.yy * strain.yy + stress.xy * strain.xy);
}

/// Speed of compression waves, sqrt((lambda + 2 G) / density) [m/s]; density [kg/m3].
double compression_wave_speed(const Elasticity& moduli, double density);

/// Speed of shear waves, sqrt(G / density) [m/s]; density [kg/m3].
double shear_wave_speed(const Elasticity& moduli, double density);

}  // namespace fissura::structure
