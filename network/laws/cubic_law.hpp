// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace fissura::network {

/// Intrinsic permeability of parallel plates, k = e^2 / 12 [m2] (Witherspoon et al. 1980; Profit et al. 2016,
/// Eq. 3).
/// @param aperture  e [m]
double permeability(double aperture);

/// Aperture of the segment between two nodes, each lifted to the floor: (max(e_a, e_min) + max(e_b, e_min)) /
/// 2 [m]. The floor lets fluid reach a closed node; it stores nothing. A harmonic mean would shut the face at
/// a tip.
double segment_aperture(double aperture_a, double aperture_b, double minimum_aperture);

/// T of q = T (p_a - p_b), flow from a to b per unit thickness [m2/s]:  T = e^3 / (12 mu L)   [m2/(s Pa)].
/// @param aperture   of the segment [m], > 0
/// @param viscosity  mu, of the equivalent Newtonian fluid [Pa s], > 0
/// @param length     L [m], > 0
double transmissibility(double aperture, double viscosity, double length);

}  // namespace fissura::network
