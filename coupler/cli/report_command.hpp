// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace fissura::coupler {

/// `coupler report`: writes the page of a run directory to `page`, by default report.html in it, and tells
/// where. The run is only read. Throws Error. @returns the exit code
int report_command(const std::filesystem::path& run_directory,
                   const std::optional<std::filesystem::path>& page);

}  // namespace fissura::coupler
