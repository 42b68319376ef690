// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "tests/reference/material.hpp"

/// Approximate solution of a plane-strain hydraulic fracture with toughness, viscosity and Carter leak-off:
/// E. V. Dontsov, Int. J. Fract. 205 (2017) 221.
///
/// The universal tip asymptote (tip_asymptote.hpp) is taken to hold up to the inlet, s = L, with V = alpha L
/// / t and alpha = d ln L / d ln t; the width between is  w = w_a ((1 + xi)/2)^lambda (1 - xi)^delta,  delta
/// = (1 + d)/2, and lambda is interpolated between the vertices (0.588 M, 0.520 M~, 0.5 K and K~). The global
/// balance closes it:
///   Q_0 t = 2 int_0^L w dx + 4 C' sqrt(t) L alpha B(alpha, 3/2).
/// Length and width are within about 1 % of the numerical solution (the author's claim).
///
/// The inlet pressure is not part of that paper. Here the flux of the profile gives the pressure drop
/// (lubrication), and the reciprocal theorem its level: the elastic volume of the pressure equals the volume
/// of the profile,
///   p(0) = E' V / (2 pi L^2) + (4/pi) int_0^L (mu' q / w^3) H(x/L) dx,  H(xi) = (acos xi - xi sqrt(1 -
///   xi^2))/2.
/// No derivative of the width at its kink x = 0 is taken.
namespace fissura::reference::kgd_dontsov {

/// The solution at one time [s], > 0.
KgdState state(const ScaledParameters& p, double time);

/// w(x) [m] at `time` and x = xi L, for each xi in 0 ... 1.
std::vector<double> aperture(const ScaledParameters& p, double time, const std::vector<double>& xi);

}  // namespace fissura::reference::kgd_dontsov
