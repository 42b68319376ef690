// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

/// Several fluids in one fracture displace each other like pistons: in a segment they lie one behind the
/// other, so their pressure drops add and the mixture's viscosity is the mean by volume, exact for Newtonian
/// fluids with a sharp front.
namespace fissura::network {

/// mu = sum_f phi_f mu_f / sum_f phi_f   [Pa s].
/// @param amounts      phi_f [n_fluids], >= 0, in any unit of volume, not all zero
/// @param viscosities  mu_f [n_fluids] [Pa s]
double mixture_viscosity(std::span<const double> amounts, std::span<const double> viscosities);

/// 1 / K = sum_f phi_f / K_f / sum_f phi_f: under one pressure the volume changes add. [Pa]
double mixture_bulk_modulus(std::span<const double> amounts, std::span<const double> bulk_moduli);

}  // namespace fissura::network
