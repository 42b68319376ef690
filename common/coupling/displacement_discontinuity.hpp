// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace fissura {

/// A straight element of constant displacement discontinuity in an infinite plane-strain body.
struct DiscontinuityElement {
  double x = 0, y = 0;         ///< centre [m]
  double tangent_x = 1, tangent_y = 0;
  double half_length = 0;      ///< [m], > 0
};

/// Opening of every element [m] under unit pressure (1 Pa) in all of them, free of shear traction: the solution of
///   sum_j K_ij D_j = 1                                            (Crouch & Starfield 1983, chapter 5; normal and shear dofs)
/// Negative values occur for closely spaced parallel elements. A dense solve: cost grows with the cube of the count.
/// @param plane_strain_modulus  E' [Pa]; Poisson's ratio does not enter in plane strain beyond it
std::vector<double> opening_under_unit_pressure(const std::vector<DiscontinuityElement>& elements,
                                                double plane_strain_modulus);

}  // namespace fissura
