// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Two parallel cracks of equal length, one above the other, under the same net pressure in an infinite plane
/// (plane strain), by displacement discontinuities of constant opening and sliding per cell: S. L. Crouch and
/// A. M. Starfield, Boundary Element Methods in Solid Mechanics (1983), chapter 5.
namespace fissura::reference::parallel_cracks {

/// Opening in the middle of either crack over that of a single one.
/// @param spacing  distance between the cracks over their half-length;  @param cells  of one crack, an odd
/// number
double relative_middle_opening(double spacing, int cells);

}  // namespace fissura::reference::parallel_cracks
