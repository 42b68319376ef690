// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/neighbour_grid.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::coupler {

namespace {

// Cells are wider than the radius by this share, so that rounding never puts neighbours two cells apart.
constexpr double margin = 1 + 1e-6;

}  // namespace

int NeighbourGrid::level_of(double radius) {
  return static_cast<int>(std::ceil(std::log2(radius * margin)));
}

std::array<std::int64_t, 2> NeighbourGrid::cell_of(const GridPoint& point, int level) {
  const double side = std::ldexp(1.0, level);
  return {static_cast<std::int64_t>(std::floor(point.position[0] / side)),
          static_cast<std::int64_t>(std::floor(point.position[1] / side))};
}

std::uint64_t NeighbourGrid::key(int level, std::int64_t column, std::int64_t row) {
  constexpr std::uint64_t low = (1ull << 28) - 1;
  return (static_cast<std::uint64_t>(level) << 56) | ((static_cast<std::uint64_t>(column) & low) << 28) |
         (static_cast<std::uint64_t>(row) & low);
}

void NeighbourGrid::remove(std::vector<GridPoint>& points, std::size_t index) {
  points[index] = points.back();
  points.pop_back();
  --size_;
}

void NeighbourGrid::put(std::vector<GridPoint>& points, const GridPoint& point) {
  for (std::size_t k = 0; k < points.size();) {
    const GridPoint& other = points[k];
    if (other.position == point.position && other.radius <= point.radius && other.reach <= point.reach)
      remove(points, k);
    else
      ++k;
  }
  points.push_back(point);
  ++size_;
}

void NeighbourGrid::insert(const GridPoint& point, double time) {
  const int own = level_of(point.radius);
  for (const int level : levels_) {
    if (level < own) continue;
    const auto [column, row] = cell_of(point, level);
    Cell& cell = cells_[key(level, column, row)];
    put(level == own ? cell.own : cell.smaller, point);
  }
  if (size_ > drop_at_) drop_ended(time);
}

void NeighbourGrid::provide(int level) {
  if (std::binary_search(levels_.begin(), levels_.end(), level)) return;
  std::vector<GridPoint> smaller;
  for (const auto& [code, cell] : cells_)
    for (const GridPoint& point : cell.own)
      if (level_of(point.radius) < level) smaller.push_back(point);
  levels_.insert(std::upper_bound(levels_.begin(), levels_.end(), level), level);
  for (const GridPoint& point : smaller) {
    const auto [column, row] = cell_of(point, level);
    put(cells_[key(level, column, row)].smaller, point);
  }
}

void NeighbourGrid::drop_ended(double time) {
  const auto ended = [time](const GridPoint& point) { return point.reach < time; };
  size_ = 0;
  for (auto cell = cells_.begin(); cell != cells_.end();) {
    std::erase_if(cell->second.own, ended);
    std::erase_if(cell->second.smaller, ended);
    const std::size_t points = cell->second.own.size() + cell->second.smaller.size();
    size_ += points;
    cell = points == 0 ? cells_.erase(cell) : std::next(cell);
  }
  drop_at_ = std::max<std::size_t>(4096, 2 * size_);
}

}  // namespace fissura::coupler
