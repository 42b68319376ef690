// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/mesh.hpp"

#include "structure/mesh/triangle_shape.hpp"

namespace fissura::structure {

double element_area(const Mesh& mesh, ElementIndex element) {
  const auto [a, b, c] = mesh.elements[element];
  return twice_area(mesh.position[a], mesh.position[b], mesh.position[c]) / 2;
}

}  // namespace fissura::structure
