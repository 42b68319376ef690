// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

/// The files of RUN/segments by their names.
namespace fissura::coupler {

/// "000042.h5".
std::string segment_name(std::uint64_t number);

/// Renames every segment numbered above `last` in `folder` to NAME.superseded (or NAME.2.superseded, if that
/// is there), removes every `.part`, and makes that durable: a run goes on from where there were only `last`
/// segments. Nothing if the folder is not there. Throws StorageError.
void supersede_segments_after(std::uint64_t last, const std::filesystem::path& folder);

}  // namespace fissura::coupler
