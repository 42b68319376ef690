// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/hilbert.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fissura::structure {
namespace {

constexpr int levels = 26;

std::uint64_t hilbert_index(std::uint32_t x, std::uint32_t y) {
  std::uint64_t index = 0;
  for (std::uint32_t half = 1u << (levels - 1); half > 0; half /= 2) {
    const bool right = (x & half) != 0, top = (y & half) != 0;
    index = 4 * index + (right ? (top ? 2u : 3u) : (top ? 1u : 0u));
    if (!top) {
      if (right) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return index;
}

}  // namespace

std::vector<std::uint32_t> hilbert_order(std::span<const Point> points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point low{infinity, infinity}, high{-infinity, -infinity};
  for (const Point& point : points)
    for (int k : {0, 1}) {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  const double extent = std::max(high[0] - low[0], high[1] - low[1]);
  const double cells = extent > 0 ? ((1u << levels) - 1) / extent : 0.0;

  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  keys.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
    keys.emplace_back(hilbert_index(static_cast<std::uint32_t>((points[i][0] - low[0]) * cells),
                                    static_cast<std::uint32_t>((points[i][1] - low[1]) * cells)),
                      i);
  std::sort(keys.begin(), keys.end());

  std::vector<std::uint32_t> order;
  order.reserve(keys.size());
  for (const auto& key : keys) order.push_back(key.second);
  return order;
}

}  // namespace fissura::structure
