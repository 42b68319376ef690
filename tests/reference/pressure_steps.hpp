// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

/// A crack -1 <= x <= 1 whose net pressure, symmetric, falls from its value at the middle in steps at given
/// points. Everything is written with the gap s = 1 - |x|, which keeps its digits at the tip. With c(x) =
/// sqrt(1 - x^2) the opening of a pressure Pi is w(x) = (4/(pi E')) int_0^1 Pi G d eta, G = ln |(c(x) +
/// c(eta)) / (c(x) - c(eta))|: I. N. Sneddon and M. Lowengrub, Crack Problems in the Classical Theory of
/// Elasticity (1969). Closed forms of its integrals over a step follow.
namespace fissura::reference::pressure_steps {

/// Points that crowd at the tip as s = u^9, u uniform, and the length of crack that each stands for; from the
/// tip.
struct Points {
  Eigen::VectorXd gap;
  Eigen::VectorXd weight;
};
Points points(int count);

/// c(x)
double chord(double gap);

/// acos(x): pi/2 minus it is int_0^x d eta / c(eta), the weight of the stress intensity factor.
double angle(double gap);

/// int_b^1 G(x, eta) d eta, the opening lost at `gap` by a unit drop of pressure beyond b = 1 -
/// `gap_of_step`; int_0^1 G d eta = pi c(x).
double lost_opening(double gap, double gap_of_step);

/// int_b^1 c d eta, the volume lost by a unit drop beyond b; int_0^1 c d eta = pi/4.
double lost_volume(double gap_of_step);

/// lost_opening of every pair of points: row = where, column = step.
Eigen::MatrixXd lost_openings(const Points& points);

}  // namespace fissura::reference::pressure_steps
