// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace fissura::coupler {

/// `text` as one cell of a CSV line (RFC 4180): in quotes if it holds a comma, a quote or the end of a line.
std::string csv_cell(const std::string& text);

}  // namespace fissura::coupler
