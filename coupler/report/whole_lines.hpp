// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fissura::coupler {

/// The lines of a text file that have been written to their end. Throws InputError if it cannot be read.
std::vector<std::string> whole_lines(const std::filesystem::path& file);

/// The whole content of a file. Throws InputError if it cannot be read.
std::string whole_text(const std::filesystem::path& file);

}  // namespace fissura::coupler
