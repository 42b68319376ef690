// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

/// The files of page/ and the charting library (Chart.js, MIT licence), taken into the program when it is
/// built.
namespace fissura::coupler::page_files {

extern const std::string_view page_html, page_css, chart_library;
extern const std::span<const std::string_view> scripts;  ///< in the order in which the page runs them

}  // namespace fissura::coupler::page_files
