// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

/// Injection into the middle of a straight crack that cannot grow, solved monolithically: aperture and
/// pressure of all cells together. Elasticity by displacement discontinuities (quasi-static), lubrication
/// with the cubic law, backward Euler in time:
///   p = A e,   l (e (1 + p/K_f))_(t+dt) - l (e (1 + p/K_f))_t = dt (sum_j T_ij (p_j - p_i) + q_i),
///   T_ij = ((e_i + e_j)/2)^3 / (12 mu l)
/// with equal cells of length l and the injection in the middle one. Pressures are net of the closure stress,
/// which is 0.
namespace fissura::reference::fixed_crack {

struct Parameters {
  double half_length = 0;           ///< a [m]
  double plane_strain_modulus = 0;  ///< E' [Pa]
  double viscosity = 0;             ///< mu [Pa s]
  double bulk_modulus = 0;          ///< K_f [Pa]
  double rate = 0;                  ///< of both wings [m2/s], from t = 0
  double initial_pressure = 0;      ///< uniform at t = 0 [Pa]
};

struct Inlet {
  double time = 0;      ///< [s]
  double aperture = 0;  ///< [m]
  double pressure = 0;  ///< [Pa]
};

/// The inlet at each of the increasing `times` [s], multiples of `step` [s]; `cells` is odd.
/// Throws std::runtime_error if a step does not converge.
std::vector<Inlet> solve(const Parameters& parameters, int cells, double step,
                         const std::vector<double>& times);

/// The limit of vanishing cells and steps: Richardson extrapolation from `cells` and about twice as many, and
/// from `step` and half of it (both errors are of first order).
std::vector<Inlet> extrapolate(const Parameters& parameters, int cells, double step,
                               const std::vector<double>& times);

/// The run of the case `fixed_crack`.
Parameters case_parameters();
std::vector<double> case_times();

}  // namespace fissura::reference::fixed_crack
