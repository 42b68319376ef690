// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace fissura::coupler {

/// The values of a CSV file of numbers, by column, below its header: every double as it was printed. Throws
/// Error(checkpoint_unusable), naming file and line, if a line has not `columns` cells or a cell is no
/// number; StorageError if the file cannot be read.
std::vector<std::vector<double>> read_number_table(const std::filesystem::path& file, std::size_t columns);

}  // namespace fissura::coupler
