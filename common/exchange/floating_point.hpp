// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace fissura {

/// What is no longer as IEEE 754 has it by default in the thread that calls, in words: the direction of
/// rounding, or that numbers below the smallest normal one are replaced by zero. A library that a solver
/// calls may have left it so, and every later result would differ. Nothing if all is well.
std::optional<std::string> changed_floating_point();

}  // namespace fissura
