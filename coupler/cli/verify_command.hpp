// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace fissura::coupler {

/// `coupler verify`: prints what verify_run finds as a table, damage last. @returns the exit code: done,
/// storage_failure if a result is damaged, or checkpoint_unusable if only checkpoints are
int verify_command(const std::filesystem::path& run_directory);

}  // namespace fissura::coupler
