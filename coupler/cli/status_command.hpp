// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace fissura::coupler {

enum class StatusForm { text, json };

/// `coupler status RUN`: what a run is doing, or how it ended. @returns the exit code; throws
/// Error(precondition) if there is no run
int status_command(const std::filesystem::path& run_directory, StatusForm form);

}  // namespace fissura::coupler
