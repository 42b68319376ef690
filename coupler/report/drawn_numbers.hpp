// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

namespace fissura::coupler {

/// `value` with five significant digits: enough for a picture, and short in a file.
double for_drawing(double value);
nlohmann::json for_drawing(const std::vector<double>& values);

}  // namespace fissura::coupler
