// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

#include "coupler/conformance/driver.hpp"

namespace fissura::coupler::conformance {

/// Says `frames`, which `why` makes wrong, and requires that the candidate answers with FAIL (its role, a
/// phase, a reason, an exit code of `codes`), says nothing more, and that its process ends with that code.
/// @returns that FAIL in words
std::string require_refusal(Driver& driver, const Frames& frames, const std::set<int>& codes,
                            const std::string& why);
std::string require_refusal(Driver& driver, const Message& message, const std::set<int>& codes,
                            const std::string& why);

/// Requires that the process ends by itself within `patience` with a code of `codes`. @returns its end in
/// words
std::string require_end(Driver& driver, Seconds patience, const std::set<int>& codes, const std::string& why);

}  // namespace fissura::coupler::conformance
