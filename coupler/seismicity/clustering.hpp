// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "coupler/seismicity/neighbour_grid.hpp"
#include "coupler/seismicity/source.hpp"

namespace fissura::coupler {

/// Union-find over sources in the order of their times. Two sources of the same class are linked if their
/// distance is at most the greater r_c and the later one comes no later than the reach of the earlier one;
/// a cluster is what is linked, directly or over others.
class Clustering {
 public:
  /// @pre sources come in their order (comes_before)
  void add(const Source& source);

  /// Takes out the clusters that no source at `watermark` [s] or later can join: those whose greatest reach
  /// lies before it. Each in the order of its sources; the clusters by greatest reach, then first source.
  std::vector<std::vector<Source>> take_closed(double watermark);

  /// All sources in clusters, in their order.
  [[nodiscard]] std::vector<Source> open_sources() const;

 private:
  using Slot = std::uint32_t;
  struct Member {
    Source source;
    double greatest_reach = 0;  // of the cluster; of its root only
    Slot parent = 0;            // itself: the root
    Slot next = 0;              // the members of a cluster form a ring
    Slot count = 0;             // of the cluster; of its root only; 0 of a free slot
  };

  Slot root_of(Slot slot);
  void unite(Slot a, Slot b);
  std::vector<Source> take(Slot root);

  std::vector<Member> members_;
  std::vector<Slot> free_;
  std::array<NeighbourGrid, 2> grids_;                             // one for each class
  double earliest_end_ = std::numeric_limits<double>::infinity();  // no cluster has a lower greatest reach
};

}  // namespace fissura::coupler
