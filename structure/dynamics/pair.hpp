// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>

namespace fissura::structure {

/// Two doubles computed at once (vector extension of GCC and Clang).
using Pair = double __attribute__((vector_size(2 * sizeof(double))));

/// The x and y component of something, from two neighbouring values in memory.
inline Pair load_pair(const double* values) {
  Pair pair;
  std::memcpy(&pair, values, sizeof(pair));
  return pair;
}

inline void store_pair(double* values, const Pair& pair) {
  std::memcpy(values, &pair, sizeof(pair));
}

}  // namespace fissura::structure
