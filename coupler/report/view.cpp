// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/view.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::coupler {

namespace {

/// Of the shape of the picture: wider than high.
View around(const char* name, double x, double y, double half_height) {
  constexpr double aspect = 1.6;
  return {name, x - aspect * half_height, x + aspect * half_height, y - half_height, y + half_height};
}

View within(const View& view, const View& domain) {
  return {view.name, std::max(view.west, domain.west), std::min(view.east, domain.east),
          std::max(view.south, domain.south), std::min(view.north, domain.north)};
}

}  // namespace

std::vector<View> views_of(const std::vector<double>& nodes, const View& domain) {
  std::vector<View> views;
  if (nodes.size() >= 4) {
    View box{"", nodes[0], nodes[0], nodes[1], nodes[1]};
    for (std::size_t node = 0; node < nodes.size(); node += 2) {
      box.west = std::min(box.west, nodes[node]);
      box.east = std::max(box.east, nodes[node]);
      box.south = std::min(box.south, nodes[node + 1]);
      box.north = std::max(box.north, nodes[node + 1]);
    }
    const double x = (box.west + box.east) / 2, y = (box.south + box.north) / 2;
    const double reach = std::max(box.east - box.west, box.north - box.south) / 2;
    std::size_t tip = 0;
    for (std::size_t node = 0; node < nodes.size(); node += 2)
      if (std::hypot(nodes[node] - x, nodes[node + 1] - y) > std::hypot(nodes[tip] - x, nodes[tip + 1] - y))
        tip = node;
    views.push_back(within(around("near the tip", nodes[tip], nodes[tip + 1], 0.2 * reach), domain));
    views.push_back(within(around("whole fracture", x, y, 1.3 * reach), domain));
  }
  views.push_back(domain);
  return views;
}

}  // namespace fissura::coupler
