// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "common/fracture_network/fracture_network.hpp"

namespace fissura {

/// Opening of every node per unit pressure [m/Pa] if each line of the network (trace_lines) opened by itself
/// as a straight crack of its length, its other branches aside:
///   D = (4 / E') sqrt(s (2a - s)),     at a junction the mean over the arms by length      (Sneddon 1946)
/// A line that ends at another one is not held together there, because that one slides and opens: its trace
/// goes on by half of the longest arm it meets, at most by half of its own length. A node of a ring has the
/// opening in the middle of a crack as long as the ring. Cost grows with the number of segments.
std::vector<double> line_compliance(const FractureNetwork& network, double plane_strain_modulus);

}  // namespace fissura
