// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <vector>

#include "common/fracture_network/fracture_network.hpp"

namespace fissura::test {

/// Fractures drawn line by line into one network of revision 0; corners at the same place are one node.
class TraceNetwork {
 public:
  /// A natural fracture through `corners` [m] with nodes about `spacing` apart. Corners that lines share must
  /// be given in both with the same bits.
  void add_line(const std::vector<std::array<double, 2>>& corners, double spacing);

  /// An end node stands for a whole adjoining segment, any other for half of each.
  [[nodiscard]] Insertion insertion() const;
  [[nodiscard]] FractureNetwork network() const;

 private:
  NodeId node_at(const std::array<double, 2>& place);
  void add_segment(NodeId a, NodeId b);

  std::map<std::array<double, 2>, NodeId> places_;
  Insertion insertion_;
  FractureId lines_ = 0;
};

}  // namespace fissura::test
