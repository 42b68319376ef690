// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/drawn_numbers.hpp"

#include <cmath>

namespace fissura::coupler {

double for_drawing(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double magnitude = std::floor(std::log10(std::abs(value)));
  // A power of ten is exact in binary only if positive: divide by it where the value is small.
  const double shift = std::pow(10.0, std::abs(4 - magnitude));
  return magnitude < 4 ? std::round(value * shift) / shift : std::round(value / shift) * shift;
}

nlohmann::json for_drawing(const std::vector<double>& values) {
  nlohmann::json list = nlohmann::json::array();
  for (const double value : values) list.push_back(for_drawing(value));
  return list;
}

}  // namespace fissura::coupler
