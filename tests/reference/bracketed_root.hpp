// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace fissura::reference {

/// Root of a continuous function in [low, high], low and high > 0, at whose ends it has opposite signs:
/// regula falsi in the logarithm of the argument with the Illinois modification (M. Dowell and P. Jarratt,
/// BIT 11 (1971) 168). Converged to a relative change of 1e-14 of the argument.
template <class Function>
double positive_root(double low, double high, Function&& function) {
  double a = std::log(low), b = std::log(high);
  double f_a = function(low), f_b = function(high);
  double x = a;
  for (int i = 0; i < 200; ++i) {
    const double next = b - f_b * (b - a) / (f_b - f_a);
    const double change = std::abs(next - x);
    x = next;
    const double f = function(std::exp(x));
    if (f == 0 || change < 1e-14) break;
    if ((f < 0) != (f_b < 0)) {
      a = b;
      f_a = f_b;
    } else {
      f_a /= 2;
    }
    b = x;
    f_b = f;
  }
  return std::exp(x);
}

}  // namespace fissura::reference
