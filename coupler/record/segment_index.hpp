// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "coupler/record/hdf5_file.hpp"

/// How the closed segments of a run directory are read (docs/results.md).
namespace fissura::coupler {

/// The lines of segments/index.jsonl that have been written to their end, each as its own checksum says it
/// was written. Throws StorageError with the number of a line that was not, or if the file cannot be read.
std::vector<nlohmann::json> segment_index(const std::filesystem::path& index);

/// The segment that `line` of the index names, in the same folder. HDF5 sees only bytes whose SHA-256 is that
/// of the line: it may crash over others. Throws StorageError.
Hdf5File open_segment(const std::filesystem::path& folder, const nlohmann::json& line);

}  // namespace fissura::coupler
