// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace fissura::coupler {

/// The page as one HTML text: markup, style, charting library and `data` (report_data.hpp) within it; a
/// browser needs nothing else. The data stand as JSON in the element with the id "data".
std::string report_page(const nlohmann::json& data);

}  // namespace fissura::coupler
