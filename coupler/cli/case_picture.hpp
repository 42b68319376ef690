// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "common/case/read_case.hpp"

namespace fissura::coupler {

/// The plan of a case as an SVG document: the domain, fracture lines and perforations, sets of natural
/// fractures by colour with a legend, places at which cleaning changed a trace, scale bar, north arrow, and
/// arrows of the greatest and least horizontal in-situ stress at the origin.
std::string case_picture(const CaseReading& reading);

}  // namespace fissura::coupler
