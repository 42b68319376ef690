// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/graph.hpp"

namespace fissura::network {

void Graph::insert(const Insertion& insertion) {
  network_.apply(insertion);
  rebuild();
}

std::span<const std::size_t> Graph::segments_at(std::size_t node) const {
  return std::span(incident_).subspan(incident_begin_[node],
                                      incident_begin_[node + 1] - incident_begin_[node]);
}

void Graph::rebuild() {
  const std::size_t nodes = node_count();
  ends_.clear();
  natural_.assign(nodes, 1);
  natural_length_.assign(nodes, 0.0);
  std::vector<std::vector<std::size_t>> incident(nodes);
  for (const NetworkSegment& segment : network_.segments()) {
    const std::size_t a = network_.index_of(segment.node_a), b = network_.index_of(segment.node_b);
    incident[a].push_back(ends_.size());
    incident[b].push_back(ends_.size());
    ends_.push_back({a, b});
    if (segment.kind == SegmentKind::hydraulic) {
      natural_[a] = natural_[b] = 0;
    } else {
      natural_length_[a] += segment.length / 2;
      natural_length_[b] += segment.length / 2;
    }
  }
  incident_begin_.assign(1, 0);
  incident_.clear();
  for (const std::vector<std::size_t>& list : incident) {
    incident_.insert(incident_.end(), list.begin(), list.end());
    incident_begin_.push_back(incident_.size());
  }
  perforations_.clear();
  for (const PerforationNode& perforation : network_.perforations())
    perforations_.push_back(network_.index_of(perforation.node));
  lumped_length_.clear();
  for (const NetworkNode& node : network_.nodes()) lumped_length_.push_back(node.lumped_length);
  for (std::size_t i = 0; i < nodes; ++i)
    if (incident[i].empty()) natural_[i] = 0;
  pattern_ = jacobian_pattern(nodes, ends_, perforations_);
}

}  // namespace fissura::network
