// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "coupler/verdict/verdict.hpp"

namespace fissura::coupler {

/// The verdict for a person: one aligned line for each quantity in its own unit, with the remark of what
/// could not be judged, and a last line "verdict: pass (8 of 8 quantities)"; ends with a newline.
std::string verdict_table(const Verdict& verdict);

}  // namespace fissura::coupler
