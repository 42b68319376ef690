// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>

#include "common/fracture_network/fracture_network.hpp"

namespace fissura::coupler::test {

/// Nodes 0, 1, ... `spacing` [m] apart on a line through the origin at `angle` [rad], the middle one of an
/// odd count at the origin and perforated. Every node stands for `spacing`, as if half an edge lay ahead of
/// both tips.
inline Insertion chain(std::size_t nodes, double spacing, double angle) {
  Insertion insertion;
  for (std::size_t i = 0; i < nodes; ++i) {
    const double s = spacing * (static_cast<double>(i) - static_cast<double>(nodes / 2));
    insertion.new_nodes.push_back(
        {.id = i, .x = s * std::cos(angle), .y = s * std::sin(angle), .lumped_length = spacing});
    if (i > 0) insertion.new_segments.push_back({.id = i, .node_a = i - 1, .node_b = i, .length = spacing});
  }
  insertion.new_perforations.push_back({"perforation", nodes / 2});
  return insertion;
}

inline FractureNetwork chain_network(std::size_t nodes, double spacing, double angle) {
  FractureNetwork network;
  network.apply(chain(nodes, spacing, angle));
  return network;
}

}  // namespace fissura::coupler::test
