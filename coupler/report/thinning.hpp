// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fissura::coupler {

/// Rows of a long table that are enough to draw it: the table in `parts` > 0 parts of equal length, and of
/// each part its first row and, for each of `peaks`, the row of the largest value; and the last row. All rows
/// of a table that has no more than `parts`.
/// @pre peaks of `rows` values each @returns row numbers in rising order
std::vector<std::size_t> rows_to_draw(std::size_t rows, std::span<const std::vector<double>> peaks,
                                      std::size_t parts);

/// At most `most` > 0 of `count` things, evenly spread and with the last. @returns numbers in rising order
std::vector<std::size_t> evenly_spread(std::size_t count, std::size_t most);

}  // namespace fissura::coupler
