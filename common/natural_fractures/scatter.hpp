// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>
#include <string_view>

#include "common/case/case.hpp"

namespace fissura {

/// Mean and standard deviation of a quantity.
struct Moments {
  double mean = 0, deviation = 0;
};

/// What draws of a scattered quantity have on average: the moments of a normal distribution cut at three
/// deviations (Johnson, Kotz and Balakrishnan 1994, sec. 13.10.1).
Moments moments(const Scattered& quantity);
/// The same, cut at zero besides. @pre the mean is positive
Moments positive_moments(const Scattered& quantity);

/// Random draws that are the same on every machine: the Mersenne twister, whose numbers the standard fixes,
/// and a normal deviate made from them by comparisons alone, so that no rounding of a mathematical function
/// can enter.
class Scatter {
 public:
  /// The same seed with another `name` gives other draws.
  Scatter(std::uint64_t seed, std::string_view name);

  /// Uniform in [0, 1).
  double uniform();

  /// Normal with mean 0 and deviation 1, cut at three deviations. A uniform x is accepted with probability
  /// exp(-x^2 / 2), decided by the length of a falling run of uniform numbers (von Neumann 1951, "Various
  /// techniques used in connection with random digits").
  double normal();

  double draw(const Scattered& quantity);
  /// The same, drawn again until it is positive. @pre the mean is positive
  double draw_positive(const Scattered& quantity);

 private:
  bool happens_with_probability_of_exponential(double exponent);

  std::mt19937_64 random_;
};

}  // namespace fissura
