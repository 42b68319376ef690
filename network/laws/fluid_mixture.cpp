// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/laws/fluid_mixture.hpp"

#include <cstddef>

namespace fissura::network {

double mixture_viscosity(std::span<const double> amounts, std::span<const double> viscosities) {
  double total = 0, sum = 0;
  for (std::size_t f = 0; f < amounts.size(); ++f) {
    total += amounts[f];
    sum += amounts[f] * viscosities[f];
  }
  return sum / total;
}

double mixture_bulk_modulus(std::span<const double> amounts, std::span<const double> bulk_moduli) {
  double total = 0, compression = 0;
  for (std::size_t f = 0; f < amounts.size(); ++f) {
    total += amounts[f];
    compression += amounts[f] / bulk_moduli[f];
  }
  return total / compression;
}

}  // namespace fissura::network
