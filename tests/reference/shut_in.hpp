// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "tests/reference/material.hpp"

/// A plane-strain fracture after the end of pumping, without leak-off: it creeps on as the pressure evens
/// out, until its toughness arrests it (sneddon::arrest of the injected volume).
///
/// It starts from kgd_self_similar at shut-in. Then each backward-Euler step finds aperture, inlet pressure
/// and length together from
///   lubrication  -dp/dx = mu' q / w^3,  q(x) = d/dt of the volume beyond x, on points that move with the tip
///   elasticity   w = (4 L / (pi E')) int_0^1 p G d eta (pressure_steps.hpp)
///   volume       the injected one
///   toughness    2 sqrt(L/pi) int_0^1 p / sqrt(1 - xi^2) d xi = K_Ic
/// Quasi-static; the tip is sharp (no cohesive zone).
namespace fissura::reference::shut_in {

struct Resolution {
  int points = 0;            ///< per wing
  double step_fraction = 0;  ///< time step over time since shut-in [-]
};

/// The state at each of the increasing `times` [s], all after `shut_in_time` > 0 [s]. Throws
/// std::runtime_error if a step does not converge.
std::vector<KgdState> solve(const ScaledParameters& p, double shut_in_time, const std::vector<double>& times,
                            const Resolution& resolution);

}  // namespace fissura::reference::shut_in
