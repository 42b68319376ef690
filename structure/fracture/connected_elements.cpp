// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/connected_elements.hpp"

#include <algorithm>
#include <unordered_set>

namespace fissura::structure {

std::vector<ElementIndex> connected_elements(const Mesh& mesh, const NodeElements& node_elements, NodeIndex start,
                                             const Point& centre, double radius) {
  std::vector<ElementIndex> found;
  std::unordered_set<ElementIndex> seen_elements;
  std::unordered_set<NodeIndex> seen_nodes{start};
  std::vector<NodeIndex> front{start};
  constexpr std::size_t usual = 512;  // elements around a tip, more than most circles hold
  seen_elements.reserve(usual);
  seen_nodes.reserve(usual);
  while (!front.empty()) {
    const NodeIndex node = front.back();
    front.pop_back();
    for (const ElementIndex element : node_elements.of(node)) {
      if (!seen_elements.insert(element).second) continue;
      found.push_back(element);
      for (const NodeIndex corner : mesh.elements[element]) {
        const Point& at = mesh.position[corner];
        const double dx = at[0] - centre[0], dy = at[1] - centre[1];
        if (dx * dx + dy * dy > radius * radius) continue;
        if (seen_nodes.insert(corner).second) front.push_back(corner);
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace fissura::structure
