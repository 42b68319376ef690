// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "common/seismicity/source_record.hpp"

namespace fissura::coupler {

/// Calls `take` with the records of sources in the closed segments of a run, group by group in the order of
/// writing, and the simulated time [s] up to which each group completes the records.
/// Throws Error(precondition) if the run directory has no index of segments or that tells nothing of sources,
/// StorageError if a segment is damaged, ProtocolError and ValueError as records_of().
/// @returns the number of groups
std::uint64_t for_each_source_group(
    const std::filesystem::path& run_directory,
    const std::function<void(double time, const std::vector<SourceRecord>&)>& take);

}  // namespace fissura::coupler
