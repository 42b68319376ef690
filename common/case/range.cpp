// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/range.hpp"

#include <cmath>

#include <fmt/format.h>

namespace fissura::input {

std::string describe(const Range& range, std::string_view unit) {
  const std::string suffix = unit.empty() ? "" : fmt::format(" {}", unit);
  std::string text;
  if (std::isfinite(range.lower))
    text = fmt::format("{} {}{}", range.lower_allowed ? "at least" : "greater than", range.lower, suffix);
  if (std::isfinite(range.upper)) {
    if (!text.empty()) text += " and ";
    text += fmt::format("{} {}{}", range.upper_allowed ? "at most" : "less than", range.upper, suffix);
  }
  return text.empty() ? "of any size" : text;
}

}  // namespace fissura::input
