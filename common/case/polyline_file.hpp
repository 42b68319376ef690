// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "common/case/case.hpp"

/// Polylines from files beside case.toml.
namespace fissura::input {

/// The file `name` of a case, which must be a relative path that stays in `folder`, symbolic links resolved.
/// Throws InputError if it is not, or if there is no such file; what() stands behind "expected".
std::filesystem::path inside(const std::filesystem::path& folder, const std::string& name);

/// Reads a polyline: one `x,y` [m] per line; lines that are empty or begin with `#` are skipped. Throws
/// InputError, naming file and line, unless there are at least two points and every line holds two finite
/// numbers.
std::vector<Point> read_polyline(const std::filesystem::path& file);

/// Reads straight lines: one `x1,y1,x2,y2` [m] per line, the two ends of each; otherwise as read_polyline.
/// Throws InputError unless there is at least one.
std::vector<std::array<Point, 2>> read_trace_ends(const std::filesystem::path& file);

}  // namespace fissura::input
