// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace fissura::coupler {

enum class StopTime { next_coupling_time, at_once };

/// `coupler stop RUN`: asks the run to end, at the next coupling time with a checkpoint or at once, waits for
/// that and prints its last line.
/// @param patience  wall seconds to wait for the end
/// @returns 0 if the run ended as asked or was complete before that, otherwise the exit code of the run.
/// Throws Error: (precondition) if `run_directory` holds no run, none that is going on, or one of another
/// user; (participant_unresponsive) if the run is still there after `patience`
int stop_command(const std::filesystem::path& run_directory, StopTime when, double patience);

}  // namespace fissura::coupler
