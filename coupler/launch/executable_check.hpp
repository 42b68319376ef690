// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace fissura::coupler {

/// Why the shell could not execute the first word of `command`: "/nowhere/solver: No such file or directory",
/// no permission, a program of another kind of processor. Nothing if it can, or if only the shell can know
/// ($VARIABLE and the like).
std::optional<std::string> why_not_executable(const std::string& command);

}  // namespace fissura::coupler
