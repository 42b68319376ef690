// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/mesh.hpp"

#include "structure/mesh/triangle_shape.hpp"

namespace fissura::structure {

EdgeIndex add_edge(Mesh& mesh, FractureEdge edge) {
  const auto index = static_cast<EdgeIndex>(mesh.edges.size());
  mesh.vertices[edge.begin].edges.push_back(index);
  mesh.vertices[edge.end].edges.push_back(index);
  mesh.edges.push_back(edge);
  return index;
}

double element_area(const Mesh& mesh, ElementIndex element) {
  const auto [a, b, c] = mesh.elements[element];
  return twice_area(mesh.position[a], mesh.position[b], mesh.position[c]) / 2;
}

}  // namespace fissura::structure
