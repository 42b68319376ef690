// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Power-law fluid between parallel plates (Profit et al. 2016, Eq. 5; Bird, Stewart and Lightfoot, Transport
/// Phenomena).
///   tau = K gamma^n,    wall shear rate  gamma_w = ((2n + 1) / (3n)) (6 V / e),    wall stress  e |grad p| /
///   2 = K gamma_w^n
/// The equivalent viscosity mu_n is the one that makes the cubic law exact:  V = -(e^2 / (12 mu_n)) grad p.
namespace fissura::network {

struct PowerLaw {
  double consistency_index = 0;  ///< K [Pa s^n], > 0
  double power_index = 1;        ///< n [-], > 0; Newtonian for 1, with K the viscosity

  [[nodiscard]] bool newtonian() const { return power_index == 1; }
};

/// Gradient below which a power-law fluid is taken as Newtonian, so that a fluid at rest has a viscosity
/// [Pa/m].
inline constexpr double gradient_floor = 10;

/// mu_n = K ((2n + 1) / (3n))^n (6 V / e)^(n - 1)   [Pa s].
/// @param aperture  e [m], > 0
/// @param velocity  magnitude of the mean velocity V [m/s], > 0 unless Newtonian
double viscosity_from_velocity(const PowerLaw& fluid, double aperture, double velocity);

/// mu_n = ((2n + 1) / (3n)) K^(1/n) (e |grad p| / 2)^((n - 1) / n)   [Pa s].
/// @param gradient  magnitude of the pressure gradient [Pa/m], > 0 unless Newtonian
double viscosity_from_gradient(const PowerLaw& fluid, double aperture, double gradient);

/// |grad p| = (2 K / e) (((2n + 1) / (3n)) (6 V / e))^n   [Pa/m], the gradient that drives the mean velocity
/// V.
double gradient_from_velocity(const PowerLaw& fluid, double aperture, double velocity);

/// Viscosity to be used in the next solution, from the gradient and the velocity of the last one [Pa s]:
///   G = |grad p|^w G(V)^(1 - w),   w = n / (1 + n),   mu = mu_n(sqrt(G^2 + gradient_floor^2))
/// Where the flow is given, the velocity alone would be right at once and the gradient alone would be wrong
/// by its power (1/n - 1), which need not converge; where the pressures are given it is the other way round.
/// This weight errs by |1 - n| / (1 + n) of the previous error in both.
/// @param gradient, velocity  magnitudes of the last solution [Pa/m], [m/s]; may be zero
double secant_viscosity(const PowerLaw& fluid, double aperture, double gradient, double velocity);

}  // namespace fissura::network
