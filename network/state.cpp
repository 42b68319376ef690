// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/state.hpp"

#include <cmath>

namespace fissura::network {

void CompensatedSum::add(double term) {
  const double total = sum + term;
  correction += std::abs(sum) >= std::abs(term) ? (sum - total) + term : (term - total) + sum;
  sum = total;
}

}  // namespace fissura::network
