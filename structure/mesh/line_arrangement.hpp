// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "common/case/case.hpp"
#include "common/case/line_limits.hpp"

namespace fissura::structure {

/// A straight stretch of a fracture line that touches other lines at its ends only.
struct LinePiece {
  std::uint32_t begin = 0, end = 0;  ///< vertices, in the direction of the line
  std::uint32_t line = 0;            ///< index into Case::fractures
};

/// The fracture lines cut at every point where they meet.
struct LineArrangement {
  std::vector<Point> vertices;    ///< given points, crossings, touches and perforations, each once [m]
  std::vector<LinePiece> pieces;  ///< line by line, along each line
};

/// Cuts the fracture lines of a case where they cross, touch or share points, and at perforations (unless a
/// vertex lies within smallest_gap of them). An end within touch_tolerance of a line or a side of the domain
/// is joined to it. Throws InputError, naming lines and coordinates, if a point lies outside the domain, a
/// stretch has no length, two lines (or a line and itself, or a side) share a stretch, or meet at less than
/// smallest_line_angle, or pass one another nearer than smallest_gap without meeting.
LineArrangement arrange_lines(const Case& given);

}  // namespace fissura::structure
