// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/floating_point.hpp"

#include <cfenv>
#include <limits>

namespace fissura {

std::optional<std::string> changed_floating_point() {
  switch (std::fegetround()) {
    case FE_TONEAREST: break;
    case FE_UPWARD: return "numbers are rounded upward instead of to nearest";
    case FE_DOWNWARD: return "numbers are rounded downward instead of to nearest";
    case FE_TOWARDZERO: return "numbers are rounded toward zero instead of to nearest";
    default: return "numbers are rounded in an unknown direction instead of to nearest";
  }
  // volatile: the compiler would compute with the modes of its own.
  volatile double smallest_normal = std::numeric_limits<double>::min();
  volatile double denormal = std::numeric_limits<double>::denorm_min(), one = 1;
  volatile double half = smallest_normal / 2, same = denormal * one;
  if (!(half > 0) || !(same > 0)) return "numbers below the smallest normal one are replaced by zero";
  return std::nullopt;
}

}  // namespace fissura
