// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/fracture_network/fracture_network.hpp"
#include "network/jacobian_pattern.hpp"

namespace fissura::network {

/// The fracture network with what the flow solution needs to walk through it. Nodes are the positions in
/// network().nodes(), segments the positions in network().segments(). Changes only in insert.
class Graph {
 public:
  Graph() = default;
  /// Of a network as it stands.
  explicit Graph(FractureNetwork network) : network_(std::move(network)) { rebuild(); }

  /// Applies one change of topology; throws ProtocolError, leaving the graph as it was, if FractureNetwork
  /// refuses it.
  void insert(const Insertion& insertion);

  [[nodiscard]] const FractureNetwork& network() const { return network_; }
  [[nodiscard]] std::size_t node_count() const { return network_.nodes().size(); }
  [[nodiscard]] std::size_t segment_count() const { return ends_.size(); }

  /// The two nodes of every segment; a flux is positive from a to b.
  [[nodiscard]] const std::vector<SegmentEnds>& ends() const { return ends_; }
  /// The segments at `node`, in their order.
  [[nodiscard]] std::span<const std::size_t> segments_at(std::size_t node) const;
  /// The node across `segment` from `node`.
  [[nodiscard]] std::size_t across(std::size_t segment, std::size_t node) const {
    return ends_[segment].a == node ? ends_[segment].b : ends_[segment].a;
  }
  /// The node of every perforation.
  [[nodiscard]] const std::vector<std::size_t>& perforations() const { return perforations_; }
  /// Lumped length l of every node [m].
  [[nodiscard]] const std::vector<double>& lumped_length() const { return lumped_length_; }
  /// Whether only natural fractures meet at `node`.
  [[nodiscard]] bool natural(std::size_t node) const { return natural_[node] != 0; }
  /// Half of every natural segment at every node [m].
  [[nodiscard]] const std::vector<double>& natural_length() const { return natural_length_; }
  [[nodiscard]] const JacobianPattern& pattern() const { return pattern_; }

 private:
  void rebuild();

  FractureNetwork network_;
  std::vector<SegmentEnds> ends_;
  std::vector<std::size_t> incident_begin_, incident_;
  std::vector<std::size_t> perforations_;
  std::vector<double> lumped_length_, natural_length_;
  std::vector<unsigned char> natural_;
  JacobianPattern pattern_;
};

}  // namespace fissura::network
