// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "coupler/checkpoint/manifest.hpp"

namespace fissura::coupler {

/// RUN/epochs.jsonl: one line for every time the run was taken up: `epoch`, `resumed_after` (coupling
/// interval; null from the beginning), `pid` of the worker, `started` (UTC); and if another flow solver went
/// on than the one before, `network` (`from`, `to`).

/// How often the run has been taken up so far.
std::uint32_t epochs_so_far(const std::filesystem::path& run_directory);

/// Enters in the last line that another flow solver goes on, durably. Throws StorageError.
void note_network_change(const std::filesystem::path& run_directory, const NetworkChange& change);

/// Adds a line, durably. Throws StorageError.
void note_epoch(const std::filesystem::path& run_directory, std::uint32_t epoch,
                const std::optional<std::uint64_t>& resumed_after);

}  // namespace fissura::coupler
