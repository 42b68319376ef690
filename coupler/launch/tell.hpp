// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace fissura::coupler {

/// Writes `line` on standard error; on a terminal in place of a progress line that may stand there.
void tell(const std::string& line);

}  // namespace fissura::coupler
