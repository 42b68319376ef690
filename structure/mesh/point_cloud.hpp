// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "common/case/case.hpp"

namespace fissura::structure {

/// Points of the mesh: first `prescribed` ones that never move, then interior ones.
struct PointCloud {
  std::vector<Point> points;  ///< [m]
  std::uint32_t prescribed = 0;
  std::vector<char>
      held;  ///< of each point: not to be moved or removed (prescribed, or in an undisturbed row)
};

/// Finds out whether a place is taken, for points of very different spacing: one hash grid per octave of
/// spacing.
class OccupancyGrid {
 public:
  /// Remembers `point`, whose neighbours stand about `spacing` [m] away.
  void add(Point point, double spacing);

  /// Distance from `point` to the nearest remembered point of at least `finest` spacing [m], if it is less
  /// than `radius` [m]; else `radius`.
  [[nodiscard]] double nearest(Point point, double radius, double finest) const;

 private:
  struct Cells {
    double width = 0;
    std::unordered_map<std::uint64_t, std::vector<Point>> content;
  };
  std::map<int, Cells> octaves_;
};

}  // namespace fissura::structure
