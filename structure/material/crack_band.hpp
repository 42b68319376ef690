// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace fissura::structure {

/// Width of the band a crack with the given normal occupies in a constant-strain triangle [m] (Oliver 1989):
///   l = 1 / sum of grad N_i . n  over the nodes on the positive side of the line through the centroid,
/// and at most the longest edge, which only slivers reach.
/// `corner` are the three corners [m], counter-clockwise; `normal` is a unit vector of either sign.
double crack_band_length(const std::array<std::array<double, 2>, 3>& corner,
                         const std::array<double, 2>& normal);

}  // namespace fissura::structure
