// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

/// Numerical solution of a plane-strain hydraulic fracture without leak-off, in a power-law fluid, with
/// toughness. J. I. Adachi and E. Detournay, Int. J. Numer. Anal. Meth. Geomech. 26 (2002) 579; for n = 1 and
/// toughness D. I. Garagash, Int. J. Solids Struct. 43 (2006) 5811.
///
/// Scaling, with both wings' rate Q and the consistency index K of tau = K gamma^n:
///   M' = 2^(n+1) (2n+1)^n n^(-n) K,  eps = (M' / (E' t^n))^(1/(n+2)),  l = (Q t / eps)^(1/2)
///   L = l gamma,  w = eps l Omega(xi),  p = E' eps Pi(xi),  toughness = K' / (E' eps l^(1/2))
/// For n = 1 M' = 12 mu, and the toughness is K_m and constant: the solution is exactly self-similar. For n
/// != 1 it is so without toughness; with it, the toughness changes as t^(-(1-n)/(2(n+2))) and the solution of
/// each time is that of its own toughness.
///
/// Equations, alpha = (n+1)/(n+2), c = sqrt(1 - xi^2):
///   lubrication   -Pi' = gamma psi^n / Omega^(2n+1),  psi = gamma (int_xi^1 Omega + alpha xi Omega)
///   elasticity    Omega = (4 gamma / pi) int_0^1 Pi G d eta (pressure_steps.hpp)
///   volume        2 gamma int_0^1 Omega = 1
///   toughness     (8 sqrt(2) / pi) sqrt(gamma) int_0^1 Pi / c d eta = toughness
/// The opening of each step of pressure is exact, so no condition on the shape of the tip is imposed. Newton
/// on the apertures at the steps.
namespace fissura::reference::kgd_self_similar {

struct Solution {
  double gamma = 0;              ///< [-]
  double inlet_aperture = 0;     ///< Omega(0) [-]
  double inlet_pressure = 0;     ///< Pi(0) [-]
  std::vector<double> xi;        ///< points [-]
  std::vector<double> aperture;  ///< Omega there
  std::vector<double> pressure;  ///< Pi there
  bool converged = false;
  int iterations = 0;
  double residual = 0;  ///< largest relative change in the last Newton step
};

/// `power_index` n > 0, `toughness` > 0 (scaled as above; 0.1 stands for none: it changes nothing by more
/// than 1e-4), number of `points` per wing.
[[nodiscard]] Solution solve(double power_index, double toughness, int points);

/// Units back: half-length [m], apertures [m] and pressures [Pa] of a scaled solution.
struct Scales {
  double length = 0;     ///< l [m]
  double aperture = 0;   ///< eps l [m]
  double pressure = 0;   ///< E' eps [Pa]
  double toughness = 0;  ///< of K' [-]
};

/// `consistency_index` K [Pa s^n], `rate` of both wings [m2/s], K' = sqrt(32/pi) K_Ic [Pa m^0.5], `time` > 0
/// [s].
Scales scales(double power_index, double consistency_index, double rate, double plane_strain_modulus,
              double scaled_toughness, double time);

}  // namespace fissura::reference::kgd_self_similar
