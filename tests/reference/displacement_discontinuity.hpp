// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

/// Displacement discontinuity method on a straight line in an infinite plane (plane strain), constant opening
/// per cell: S. L. Crouch and A. M. Starfield, Boundary Element Methods in Solid Mechanics (1983), chapter 5.
namespace fissura::reference::displacement_discontinuity {

/// Cells of a straight crack between increasing `edges` [m]; n edges make n - 1 cells.
/// Returns A [Pa/m] of  p = A w:  net pressure at the cell centres that holds the cells open by w [m].
///   A_ij = -(E' / 4 pi) (1 / (x_i - x_j - a_j) - 1 / (x_i - x_j + a_j)),  a_j half the length of cell j
Eigen::MatrixXd stiffness(const std::vector<double>& edges, double plane_strain_modulus);

/// Cell centres and lengths.
std::vector<double> centres(const std::vector<double>& edges);
std::vector<double> lengths(const std::vector<double>& edges);

}  // namespace fissura::reference::displacement_discontinuity
