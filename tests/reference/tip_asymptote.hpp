// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The width near the tip of a steadily moving, fluid-driven crack with toughness, viscosity and Carter
/// leak-off: D. I. Garagash, E. Detournay and J. I. Adachi, J. Fluid Mech. 669 (2011) 260, in the closed
/// approximation of E. V. Dontsov and A. P. Peirce, J. Fluid Mech. 781 (2015) R1.
///
/// With the distance s to the tip, the speed V and the width w(s):
///   K = K' s^(1/2) / (E' w),   C = 2 C' s^(1/2) / (w V^(1/2)),   mu' V s^2 / (E' w^3) = scaled_speed(K, C).
/// Both functions expect 0 <= K <= 1 and C >= 0.
namespace fissura::reference::tip_asymptote {

/// g(K, C) = f(K, b C, c_1),  f = (1/c_1) int_K^1 u^3 / (u + C) du, c_1 and b = c_2/c_1 from the order below.
/// Zero at K = 1 (toughness alone), 1 / (2 3^(5/2)) at K = C = 0 (viscosity alone).
double scaled_speed(double toughness, double leak_off);

/// d(K, C), 0 ... 1/3: the width runs like s^((1 + d)/2) from the toughness end (0) to the viscosity end
/// (1/3).
double order(double toughness, double leak_off);

}  // namespace fissura::reference::tip_asymptote
