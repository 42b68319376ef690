// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <string_view>

namespace fissura::input {

/// The values that a key allows, in SI.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_allowed = true, upper_allowed = true;

  [[nodiscard]] constexpr bool contains(double value) const {
    return (lower_allowed ? value >= lower : value > lower) &&
           (upper_allowed ? value <= upper : value < upper);
  }
};

inline constexpr Range any_value{};
inline constexpr Range positive{0, any_value.upper, false, true};
inline constexpr Range not_negative{0, any_value.upper, true, true};
inline constexpr Range fraction{0, 1, false, true};  ///< 0 < value <= 1

constexpr Range at_least(double lower) {
  return {lower, any_value.upper, true, true};
}
constexpr Range from_to(double lower, double upper) {
  return {lower, upper, true, true};
}
constexpr Range between(double lower, double upper) {
  return {lower, upper, false, false};
}

/// "greater than 0 Pa", "at least 1", "greater than -1 and less than 0.5"; "of any size" without limits.
std::string describe(const Range& range, std::string_view unit);

}  // namespace fissura::input
