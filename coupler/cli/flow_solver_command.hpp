// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace fissura::coupler {

/// The shell word of the program `name` that stands beside this one.
std::string sibling(const std::string& name);

/// The shell command of what `--network` or `[participants] network` say: the program of a shipped flow solver
/// of that name, else the words themselves. Throws Error(precondition) if that program is not there.
std::string flow_solver_command(const std::string& words);

}  // namespace fissura::coupler
