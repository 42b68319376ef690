// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/fracture_extent.hpp"

namespace fissura::coupler {

double marked_half_length(const FractureNetwork& network, const std::vector<double>& marked) {
  double trace = 0;
  for (const NetworkSegment& segment : network.segments())
    if (segment.kind == SegmentKind::hydraulic && marked[network.index_of(segment.node_a)] > 0 && marked[network.index_of(segment.node_b)] > 0)
      trace += segment.length;
  return trace / 2;
}

double half_length(const FractureNetwork& network) {
  return marked_half_length(network, std::vector<double>(network.nodes().size(), 1));
}

}  // namespace fissura::coupler
