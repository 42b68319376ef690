// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "structure/mesh/line_arrangement.hpp"

namespace fissura::structure {

/// "(x, y) m" as written in messages.
std::string text(Point point);

/// Throws InputError if a vertex of the arrangement is nearer than smallest_gap * fracture_size to another
/// vertex, to a piece it does not belong to, or to a side of the domain it does not lie on.
void check_gaps(const LineArrangement& lines, const Case& given);

/// Throws InputError if two pieces, or a piece and a side of the domain, meet at less than
/// smallest_line_angle.
void check_angles(const LineArrangement& lines, const Case& given);

}  // namespace fissura::structure
