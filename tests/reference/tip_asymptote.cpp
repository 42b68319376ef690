// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/tip_asymptote.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fissura::reference::tip_asymptote {
namespace {

using std::numbers::pi;

constexpr std::array<double, 4> gauss_points{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                             0.9602898564975363};
constexpr std::array<double, 4> gauss_weights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                              0.1012285362903763};

const double beta_m_cubed = 2 * std::pow(3.0, 2.5);
const double beta_m_tilde_fourth = 256 / (15 * (std::numbers::sqrt2 - 1));
const double leak_off_factor = 0.75 * beta_m_tilde_fourth / beta_m_cubed;

double integral_closed(double k, double c) {
  return (1 - k * k * k) / 3 - c * (1 - k * k) / 2 + c * c * (1 - k) -
         c * c * c * std::log((1 + c) / (k + c));
}

// The closed form loses its digits to cancellation once c is large.
double integral_by_gauss(double k, double c) {
  const double middle = (1 + k) / 2, half = (1 - k) / 2;
  const auto integrand = [c](double u) { return u * u * u / (u + c); };
  double sum = 0;
  for (std::size_t i = 0; i < gauss_points.size(); ++i) {
    const double offset = half * gauss_points[i];
    sum += gauss_weights[i] * (integrand(middle - offset) + integrand(middle + offset));
  }
  return half * sum;
}

double integral(double k, double c) {
  if (c == 0) return (1 - k * k * k) / 3;
  return c < 1 ? integral_closed(k, c) : integral_by_gauss(k, c);
}

double first_coefficient(double d) {
  return 4 * (1 - 2 * d) / (d * (1 - d)) * std::tan(pi * d);
}

double second_coefficient(double d) {
  return 16 * (1 - 3 * d) / (3 * d * (2 - 3 * d)) * std::tan(1.5 * pi * d);
}

}  // namespace

double order(double toughness, double leak_off) {
  const double c = leak_off_factor * leak_off;
  return std::clamp(integral(toughness, c) * (1 + c), 0.0, 1.0 / 3);
}

double scaled_speed(double toughness, double leak_off) {
  const double d = std::clamp(order(toughness, leak_off), 1e-9, 1.0 / 3 - 1e-9);
  const double c_1 = first_coefficient(d);
  return integral(toughness, leak_off * second_coefficient(d) / c_1) / c_1;
}

}  // namespace fissura::reference::tip_asymptote
