// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "common/case/case.hpp"

namespace fissura {

/// SHA-256 of all of a case that the state of a solver depends on: not of its title, its end, its output, or how the programs are
/// watched and reached, which may be others when a run is resumed.
std::string case_hash(const Case& value);

}  // namespace fissura
