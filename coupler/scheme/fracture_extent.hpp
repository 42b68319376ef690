// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "common/fracture_network/fracture_network.hpp"

namespace fissura::coupler {

/// Half the trace length of the hydraulic segments whose two nodes are both marked [m]; both wings of a fracture together make its
/// trace. Natural fractures do not count: they are in the network as a whole as soon as they are met.
/// @param marked  one value per node, > 0 for marked
double marked_half_length(const FractureNetwork& network, const std::vector<double>& marked);

/// Half of the whole hydraulic trace [m].
double half_length(const FractureNetwork& network);

}  // namespace fissura::coupler
