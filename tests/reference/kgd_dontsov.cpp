// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/kgd_dontsov.hpp"

#include <cmath>
#include <numbers>

#include "tests/reference/bracketed_root.hpp"
#include "tests/reference/tip_asymptote.hpp"

namespace fissura::reference::kgd_dontsov {
namespace {

using std::numbers::pi;

double beta_function(double a, double b) {
  return std::exp(std::lgamma(a) + std::lgamma(b) - std::lgamma(a + b));
}

// int_0^1 ((1 + xi)/2)^lambda (1 - xi)^delta dxi, expanded in powers of (1 - xi)/2.
double profile_integral(double lambda, double delta) {
  double coefficient = 1, sum = 0;
  for (int k = 0; k < 60; ++k) {
    sum += coefficient / (k + 1 + delta);
    coefficient *= -(lambda - k) / (2 * (k + 1));
  }
  return sum;
}

struct Solution {
  double half_length = 0, tip_width = 0, speed_exponent = 0, lambda = 0, delta = 0, efficiency = 1;

  /// At the scaled distance gap = 1 - xi from the tip.
  [[nodiscard]] double aperture(double gap) const {
    return tip_width * std::pow(1 - gap / 2, lambda) * std::pow(gap, delta);
  }
};

struct Balance {
  const ScaledParameters& p;
  double time, alpha;

  [[nodiscard]] double speed(double length) const { return alpha * length / time; }
  [[nodiscard]] double toughness(double length, double width) const {
    return p.toughness * std::sqrt(length) / (p.modulus * width);
  }
  [[nodiscard]] double leak_off(double length, double width) const {
    return 2 * p.leak_off * std::sqrt(length / speed(length)) / width;
  }

  [[nodiscard]] double tip_width(double length) const {
    const double toughness_alone = p.toughness * std::sqrt(length) / p.modulus;
    const double drive = p.viscosity * speed(length) * length * length / p.modulus;
    const double viscosity_alone = std::cbrt(2 * std::pow(3.0, 2.5) * drive);
    const double leak_off_alone =
        4 * std::pow(2 * p.leak_off * std::sqrt(length / speed(length)) * drive, 0.25);
    const double low = std::max(toughness_alone * (1 + 1e-15), 0.5 * viscosity_alone);
    const double high = 2 * (toughness_alone + viscosity_alone + leak_off_alone);
    return positive_root(low, high, [&](double width) {
      const double k = std::min(1.0, toughness(length, width));
      return drive / std::pow(width, 3) - tip_asymptote::scaled_speed(k, leak_off(length, width));
    });
  }

  [[nodiscard]] double leaked(double length) const {
    return 4 * p.leak_off * std::sqrt(time) * length * alpha * beta_function(alpha, 1.5);
  }

  [[nodiscard]] Solution complete(double length) const {
    Solution s;
    s.half_length = length;
    s.speed_exponent = alpha;
    s.tip_width = tip_width(length);
    const double k = std::min(1.0, toughness(length, s.tip_width));
    s.delta = (1 + tip_asymptote::order(k, leak_off(length, s.tip_width))) / 2;
    const double first_volume = 2 * length * s.tip_width * profile_integral(0.5, s.delta);
    const double first_efficiency = first_volume / (first_volume + leaked(length));
    const double k_cubed = k * k * k;
    s.lambda = (1 - k_cubed) * (0.588 * first_efficiency + 0.520 * (1 - first_efficiency)) + 0.5 * k_cubed;
    const double volume = 2 * length * s.tip_width * profile_integral(s.lambda, s.delta);
    s.efficiency = volume / (volume + leaked(length));
    return s;
  }

  [[nodiscard]] Solution solve() const {
    const auto volume = [this](double length) {
      const Solution s = complete(length);
      return 2 * length * s.tip_width * profile_integral(s.lambda, s.delta) + leaked(length);
    };
    const double target = p.rate * time;
    double high = 1;
    while (volume(high) < target) high *= 2;
    double low = high / 2;
    while (volume(low) > target) low /= 2;
    return complete(positive_root(low, high, [&](double length) { return volume(length) / target - 1; }));
  }
};

// The exponent alpha(t) is the slope of the solution before; three passes as in the paper.
Solution solve(const ScaledParameters& p, double time, int passes) {
  double alpha = 2.0 / 3;
  if (passes > 0) {
    const double step = 0.05;
    const double later = solve(p, time * std::exp(step), passes - 1).half_length;
    const double earlier = solve(p, time * std::exp(-step), passes - 1).half_length;
    alpha = std::log(later / earlier) / (2 * step);
  }
  return Balance{p, time, alpha}.solve();
}

constexpr int exponent_passes = 3;

// H(xi) of the header with xi = cos(angle).
double reciprocal_weight(double gap) {
  const double angle = 2 * std::asin(std::sqrt(gap / 2));
  return angle < 1e-3 ? std::pow(angle, 3) / 3 : (2 * angle - std::sin(2 * angle)) / 4;
}

double inlet_pressure(const ScaledParameters& p, double time, const Solution& s) {
  const double stored = p.rate * time * s.efficiency;
  const double step = 0.05;
  const double width_exponent = std::log(solve(p, time * std::exp(step), 2).aperture(1) /
                                         solve(p, time * std::exp(-step), 2).aperture(1)) /
                                (2 * step);
  const double alpha = s.speed_exponent, length = s.half_length;

  // s = 1 - xi = u^6 takes the tip singularities out of every integrand.
  const int intervals = 2000;
  const double du = 1.0 / intervals;
  double content = 0, leak = 0, drop = 0;
  double content_before = 0, leak_before = 0;
  for (int i = 0; i < intervals; ++i) {
    const double u = (i + 0.5) * du;
    const double gap = std::pow(u, 6), weight = 6 * std::pow(u, 5) * du;
    const double w = s.aperture(gap);
    const double content_here = w * weight;
    const double leak_here = weight / std::sqrt(-std::expm1(std::log1p(-gap) / alpha));
    content += (content_before + content_here) / 2;
    leak += (leak_before + leak_here) / 2;
    content_before = content_here;
    leak_before = leak_here;
    const double flux = length / time * ((alpha + width_exponent) * content + alpha * (1 - gap) * w) +
                        p.leak_off * length / std::sqrt(time) * leak;
    drop += p.viscosity * flux / (w * w * w) * reciprocal_weight(gap) * weight * length;
  }
  return p.modulus * stored / (2 * pi * length * length) + 4 / pi * drop;
}

}  // namespace

KgdState state(const ScaledParameters& p, double time) {
  const Solution s = solve(p, time, exponent_passes);
  KgdState result;
  result.time = time;
  result.half_length = s.half_length;
  result.inlet_aperture = s.aperture(1);
  result.efficiency = s.efficiency;
  result.inlet_net_pressure = inlet_pressure(p, time, s);
  return result;
}

std::vector<double> aperture(const ScaledParameters& p, double time, const std::vector<double>& xi) {
  const Solution s = solve(p, time, exponent_passes);
  std::vector<double> result;
  result.reserve(xi.size());
  for (const double x : xi) result.push_back(s.aperture(1 - x));
  return result;
}

}  // namespace fissura::reference::kgd_dontsov
