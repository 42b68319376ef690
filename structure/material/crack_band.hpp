// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace fissura::structure {

/// Width of the band a crack with the given normal occupies in a constant-strain triangle [m]: the extent of
/// the triangle along the normal. A straight crack line that lies anywhere with equal chance cuts triangles
/// whose areas, each divided by this width, add up to the length of the line on average (the mean chord of a
/// triangle is its area over its extent), so that the fracture energy is spent once whatever the inclination
/// of the mesh. The length of Oliver (1989) is the same where an edge is parallel to the crack or to its
/// normal, and shorter between, by up to 7 % in an equilateral triangle. `corner` are the three corners [m];
/// `normal` is a unit vector of either sign.
double crack_band_length(const std::array<std::array<double, 2>, 3>& corner,
                         const std::array<double, 2>& normal);

}  // namespace fissura::structure
