// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/order.hpp"

#include "structure/mesh/hilbert.hpp"

namespace fissura::structure {
namespace {

void order_elements(Mesh& mesh) {
  std::vector<Point> centroids;
  centroids.reserve(mesh.elements.size());
  for (const auto& [a, b, c] : mesh.elements)
    centroids.push_back({(mesh.position[a][0] + mesh.position[b][0] + mesh.position[c][0]) / 3,
                         (mesh.position[a][1] + mesh.position[b][1] + mesh.position[c][1]) / 3});
  std::vector<std::array<NodeIndex, 3>> ordered;
  ordered.reserve(mesh.elements.size());
  for (const std::uint32_t element : hilbert_order(centroids)) ordered.push_back(mesh.elements[element]);
  mesh.elements = std::move(ordered);
}

void number_nodes(Mesh& mesh) {
  constexpr NodeIndex unnumbered = 0xffffffffu;
  std::vector<NodeIndex> number(mesh.position.size(), unnumbered);
  std::vector<Point> position;
  position.reserve(mesh.position.size());
  for (auto& element : mesh.elements)
    for (NodeIndex& node : element) {
      if (number[node] == unnumbered) {
        number[node] = static_cast<NodeIndex>(position.size());
        position.push_back(mesh.position[node]);
      }
      node = number[node];
    }
  mesh.position = std::move(position);
  for (auto& side : mesh.side_nodes)
    for (NodeIndex& node : side) node = number[node];
  for (FractureVertex& vertex : mesh.vertices) vertex.node = number[vertex.node];
  for (ContactUnit& unit : mesh.units) {
    unit.minus = number[unit.minus];
    unit.plus = number[unit.plus];
  }
}

}  // namespace

void order(Mesh& mesh) {
  order_elements(mesh);
  number_nodes(mesh);
}

}  // namespace fissura::structure
