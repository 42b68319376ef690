// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "common/case/case.hpp"

namespace fissura::input {

/// Natural fractures that do not hold under the in-situ stress.
struct SlipInSitu {
  std::size_t lines = 0;  ///< how many
  std::size_t worst = 0;  ///< the one with the greatest excess, index into Case::fractures
  double excess = 0;      ///< of its shear traction over its strength [Pa]
};

/// Those beyond  |tau| = c + f_t - mu sigma_n  (tension positive; Jaeger, Cook and Zimmerman 2007, ch. 3), f_t of the cement; nothing if
/// all hold.
std::optional<SlipInSitu> slip_in_situ(const Case& value);

}  // namespace fissura::input
