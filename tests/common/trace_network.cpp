// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/common/trace_network.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::test {

void TraceNetwork::add_line(const std::vector<std::array<double, 2>>& corners, double spacing) {
  NodeId last = node_at(corners.front());
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const auto &from = corners[k - 1], &to = corners[k];
    const long parts = std::max(1L, std::lround(std::hypot(to[0] - from[0], to[1] - from[1]) / spacing));
    for (long i = 1; i <= parts; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(parts);
      const NodeId next = node_at(
          i == parts ? to
                     : std::array{from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])});
      add_segment(last, next);
      last = next;
    }
  }
  ++lines_;
}

Insertion TraceNetwork::insertion() const {
  Insertion insertion = insertion_;
  std::vector<int> arms(insertion.new_nodes.size(), 0);
  for (const NetworkSegment& segment : insertion.new_segments)
    for (const NodeId node : {segment.node_a, segment.node_b}) {
      ++arms[node];
      insertion.new_nodes[node].lumped_length += segment.length / 2;
    }
  for (NetworkNode& node : insertion.new_nodes) {
    if (arms[node.id] == 1) node.lumped_length *= 2;
    node.role = arms[node.id] == 1  ? NodeRole::tip
                : arms[node.id] > 2 ? NodeRole::junction
                                    : NodeRole::interior;
  }
  return insertion;
}

FractureNetwork TraceNetwork::network() const {
  FractureNetwork network;
  network.apply(insertion());
  return network;
}

NodeId TraceNetwork::node_at(const std::array<double, 2>& place) {
  const auto [found, is_new] = places_.emplace(place, insertion_.new_nodes.size());
  if (is_new) {
    NetworkNode node;
    node.id = found->second;
    node.x = place[0];
    node.y = place[1];
    node.fracture = lines_;
    insertion_.new_nodes.push_back(node);
  }
  return found->second;
}

void TraceNetwork::add_segment(NodeId a, NodeId b) {
  const NetworkNode &from = insertion_.new_nodes[a], &to = insertion_.new_nodes[b];
  insertion_.new_segments.push_back({insertion_.new_segments.size(), a, b, lines_, SegmentKind::natural,
                                     std::hypot(to.x - from.x, to.y - from.y)});
}

}  // namespace fissura::test
