// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace fissura {

/// @returns the place of the first of `values` (any unit) that is infinite or not a number, or nothing
[[nodiscard]] std::optional<std::size_t> first_not_finite(std::span<const double> values);

/// @returns the place of the first of `values` below `minimum` or above `maximum` (same unit, both allowed),
/// or nothing. What is not a number is not looked at.
[[nodiscard]] std::optional<std::size_t> first_outside(std::span<const double> values, double minimum,
                                                       double maximum);

}  // namespace fissura
