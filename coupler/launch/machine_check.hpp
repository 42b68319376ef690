// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace fissura::coupler {

/// Throws Error(precondition) if this process may not open the files and connections that a run needs.
void require_descriptors();

}  // namespace fissura::coupler
