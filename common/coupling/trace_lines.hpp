// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "common/fracture_network/fracture_network.hpp"

namespace fissura {

/// A run of segments through junctions, as straight as it can go.
struct TraceLine {
  std::vector<std::size_t> nodes;     ///< in order; a ring names its first node again at the end
  std::vector<std::size_t> segments;  ///< between them
  double length = 0;                  ///< of all segments [m]

  [[nodiscard]] bool ring() const { return nodes.front() == nodes.back(); }
};

/// The lines of a network; every segment belongs to one. Two arms of a node are of one line if the node has
/// no other arms, or if the trace turns by less than 60 degrees between them: the straightest pair first, of
/// equal ones that whose segments come first in the network.
std::vector<TraceLine> trace_lines(const FractureNetwork& network);

}  // namespace fissura
