// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How near one another lines may come that are to be meshed.
namespace fissura {

/// Lines nearer to one another than this, in units of fracture_size, are one point: an end this close to a
/// line touches it.
inline constexpr double touch_tolerance = 1e-3;
/// Nearest that points and lines which do not meet may come, in units of fracture_size.
inline constexpr double smallest_gap = 0.15;
/// Smallest angle between lines, or a line and a side of the domain, at a common point [degrees].
inline constexpr double smallest_line_angle = 10;

}  // namespace fissura
