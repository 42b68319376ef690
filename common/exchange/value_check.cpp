// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/value_check.hpp"

#include <algorithm>
#include <cmath>

namespace fissura {

namespace {

template <typename Wrong>
std::optional<std::size_t> first(std::span<const double> values, Wrong wrong) {
  const auto found = std::ranges::find_if(values, wrong);
  if (found == values.end()) return std::nullopt;
  return static_cast<std::size_t>(found - values.begin());
}

}  // namespace

std::optional<std::size_t> first_not_finite(std::span<const double> values) {
  return first(values, [](double value) { return !std::isfinite(value); });
}

std::optional<std::size_t> first_outside(std::span<const double> values, double minimum, double maximum) {
  return first(values, [&](double value) { return value < minimum || value > maximum; });
}

}  // namespace fissura
