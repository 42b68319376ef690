// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/flow_solver/flow_solver.hpp"
#include "common/fracture_network/fracture_network.hpp"

/// Fracture networks and changes of them, as a structure would send them. Ids of nodes and segments are
/// neither dense nor in order of place, so that a solver that takes one for the other is found out.
namespace fissura::coupler::conformance {

/// A straight slit along x, centred on the origin: `nodes` >= 2 nodes at distance `spacing` [m], tips at its
/// ends, the perforation "well" at node `perforated` (counted from west). Revision 0.
Insertion straight_slit(std::size_t nodes, double spacing, std::size_t perforated);

/// The same as a natural fracture: saturated nodes at `formation_pressure` [Pa], joints of `compliance`
/// [m/Pa].
Insertion natural_slit(std::size_t nodes, double spacing, std::size_t perforated, double formation_pressure,
                       double compliance);

/// One node at distance `spacing` beyond the tip at the east end of the network's x axis.
Insertion tip_growth(const FractureNetwork& network, double spacing, double time);

/// A new arm of `length` nodes that leaves node `node` (an index) towards north, which becomes a junction.
Insertion junction(const FractureNetwork& network, std::size_t node, std::size_t length, double spacing,
                   double time);

/// Both ends grow by one node and an arm leaves node `node`, all in one insertion.
Insertion several_at_once(const FractureNetwork& network, std::size_t node, double spacing, double time);

/// Segment `segment` (an index) is removed and replaced by two with a new node in its middle; the lengths of
/// the nodes at its ends shrink.
Insertion split_segment(const FractureNetwork& network, std::size_t segment, double time);

/// A natural fracture of `length` saturated nodes that begins at node `node`.
Insertion natural_branch(const FractureNetwork& network, std::size_t node, std::size_t length, double spacing,
                         double formation_pressure, double compliance, double time);

/// Every node at the same aperture [m], which does not change; no compliance, faces apart.
CouplingInterval rigid_interval(const FractureNetwork& network, double begin, double end, double aperture);

/// Sum over nodes of lumped length times `values` (any unit), times m.
double integral(const FractureNetwork& network, const std::vector<double>& values);

}  // namespace fissura::coupler::conformance
