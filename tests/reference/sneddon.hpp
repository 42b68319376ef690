// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A straight crack of half length a under uniform net pressure p in an infinite plane (plane strain).
/// I. N. Sneddon, Proc. R. Soc. Lond. A 187 (1946) 229; also Tada, Paris and Irwin, The Stress Analysis of
/// Cracks.
namespace fissura::reference::sneddon {

/// w(x) = (4 p / E') sqrt(a^2 - x^2) [m]; `x` from the centre, |x| <= a [m].
double aperture(double net_pressure, double half_length, double plane_strain_modulus, double x);

/// V = 2 pi p a^2 / E' [m2], per unit thickness.
double volume(double net_pressure, double half_length, double plane_strain_modulus);

/// K_I = p sqrt(pi a) [Pa m^0.5].
double stress_intensity(double net_pressure, double half_length);

/// A crack of volume V at the verge of growth: K_I = K_Ic and the volume above give
///   a = (E' V / (2 sqrt(pi) K_Ic))^(2/3),  w(0) = 4 p a / E',  p = K_Ic / sqrt(pi a).
struct Arrest {
  double half_length = 0;   ///< [m]
  double aperture = 0;      ///< at the centre [m]
  double net_pressure = 0;  ///< [Pa]
};
Arrest arrest(double volume, double toughness, double plane_strain_modulus);

}  // namespace fissura::reference::sneddon
