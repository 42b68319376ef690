// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace fissura {

/// Sends `count` and `phase` of the solve loop to the coupler; installed by run_participant.
using ProgressReport = std::function<void(const char* phase, unsigned long count)>;

/// Makes note_progress (participant.hpp) call `report` at its next note and then at most ten times a second; an empty function stops it.
void set_progress_report(ProgressReport report);

/// Names the phase that begins, without a report.
void set_phase(const char* phase);

/// Phase given to set_phase or the last note_progress, for failure messages.
const char* last_phase();

}  // namespace fissura
