// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "common/fracture_network/fracture_network.hpp"

namespace fissura {

/// Interface compliance C_R of every node: `factor` times its static opening per unit uniform pressure in the connected fracture. It estimates
/// what the structure will do with a pressure increment and stores no fluid; a factor between 0.1 and 3 is harmless for length, aperture and
/// pressure. Within one interval the inertia of the rock lets only a part of the static opening happen, so a factor below 1 keeps the
/// structure's volume closer to the content.
/// All segments count, open or closed. A connected part that does not branch takes the closed form of a straight crack, in arc length; a tree
/// of at most most_nodes_of_row_sum nodes the row sum of the displacement-discontinuity method; any other each line by itself
/// (line_compliance.hpp), times least_factor_of_lines if that is more than `factor`. All have the same floor, so that k_s = 1 / C_R never exceeds E' / (2 h).
/// @param network               the graph at its present revision
/// @param plane_strain_modulus  E' [Pa]
/// @param factor                > 0 [-]
/// @returns one value per node, > 0 [m/Pa]
std::vector<double> interface_compliance(const FractureNetwork& network, double plane_strain_modulus, double factor);

inline constexpr std::size_t most_nodes_of_row_sum = 300;

/// A line opens more than by itself where its neighbours open with it; a smaller share of its own opening lets partly
/// open networks swing.
inline constexpr double least_factor_of_lines = 1;

/// Sneddon's opening of a crack of length `trace` per unit pressure at `distance` from its end along the trace [m/Pa]:
///   D = (4 / E') sqrt(s (2a - s)),   s (2a - s) >= h^2 / 4                     (Sneddon 1946)
/// @param cell  h, lumped length of the node [m]
double straight_crack_compliance(double distance, double trace, double cell, double plane_strain_modulus);

/// Smallest compliance allowed for a node of lumped length `cell`: 2 h / E' [m/Pa].
double compliance_floor(double cell, double plane_strain_modulus);

}  // namespace fissura
