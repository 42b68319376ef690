// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace fissura::coupler {

/// What the grid knows of a source.
struct GridPoint {
  std::array<double, 2> position{};  ///< [m]
  double radius = 0;                 ///< r_c [m]
  double reach = 0;                  ///< time after which nothing links to it [s]
  std::uint32_t slot = 0;            ///< whose it is
};

/// Sources in square cells, for a sweep in the order of time. Radii differ with the mesh, so there is a grid
/// for each power of two: its cells hold the points of that radius and, apart, those of smaller ones. A point
/// then finds all that lie within the greater of both radii in three by three cells of each grid that is as
/// coarse as its own or coarser.
class NeighbourGrid {
 public:
  /// Calls found(slot) for each point with reach >= time and distance <= the greater of both radii.
  /// @pre calls come in the order of time; points that ended before are dropped on the way
  template <class Found>
  void for_each_neighbour(const GridPoint& point, double time, Found found) {
    const int own = level_of(point.radius);
    provide(own);
    for (const int level : levels_) {
      if (level < own) continue;
      const auto [column, row] = cell_of(point, level);
      for (std::int64_t i = column - 1; i <= column + 1; ++i)
        for (std::int64_t j = row - 1; j <= row + 1; ++j) {
          const auto place = cells_.find(key(level, i, j));
          if (place == cells_.end()) continue;
          visit(place->second.own, point, time, found);
          if (level == own) visit(place->second.smaller, point, time, found);
        }
    }
  }

  /// Puts a point in. Points in the same place that end no later and reach no farther are dropped: whatever
  /// links to them links to this one.
  /// @pre for_each_neighbour(point, time) has been called
  void insert(const GridPoint& point, double time);

  /// Number of points that are kept [-]; some of them may have ended.
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  struct Cell {
    std::vector<GridPoint> own, smaller;
  };

  static int level_of(double radius);
  static std::array<std::int64_t, 2> cell_of(const GridPoint& point, int level);
  static std::uint64_t key(int level, std::int64_t column, std::int64_t row);

  template <class Found>
  void visit(std::vector<GridPoint>& points, const GridPoint& point, double time, Found& found) {
    for (std::size_t k = 0; k < points.size();) {
      const GridPoint& other = points[k];
      if (other.reach < time) {
        remove(points, k);
        continue;
      }
      const double radius = point.radius > other.radius ? point.radius : other.radius;
      const double x = point.position[0] - other.position[0], y = point.position[1] - other.position[1];
      if (x * x + y * y <= radius * radius) found(other.slot);
      ++k;
    }
  }

  void remove(std::vector<GridPoint>& points, std::size_t index);
  void put(std::vector<GridPoint>& points, const GridPoint& point);
  /// Makes the grid of a level if there is none, with the smaller points in it.
  void provide(int level);
  void drop_ended(double time);

  std::vector<int> levels_;  // ascending
  std::unordered_map<std::uint64_t, Cell> cells_;
  std::size_t size_ = 0, drop_at_ = 4096;
};

}  // namespace fissura::coupler
