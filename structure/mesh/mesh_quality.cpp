// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/mesh_quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "common/hash.hpp"
#include "structure/mesh/triangle_shape.hpp"

namespace fissura::structure {

MeshQuality measure(const Mesh& mesh) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  MeshQuality quality{mesh.elements.size(), mesh.position.size(), infinity, infinity, infinity, 0, {}};
  double smallest_sine = 1;
  for (const auto& [a, b, c] : mesh.elements) {
    const TriangleShape triangle = shape(mesh.position[a], mesh.position[b], mesh.position[c]);
    smallest_sine = std::min(smallest_sine, triangle.sine_of_smallest_angle);
    quality.smallest_altitude = std::min(quality.smallest_altitude, triangle.smallest_altitude);
    quality.smallest_edge = std::min(quality.smallest_edge, triangle.shortest_edge);
    quality.largest_edge = std::max(quality.largest_edge, triangle.longest_edge);
  }
  quality.smallest_angle = std::asin(smallest_sine) * 180 / std::numbers::pi;

  const auto positions = std::as_bytes(std::span(mesh.position));
  const auto elements = std::as_bytes(std::span(mesh.elements));
  std::vector<std::byte> bytes(positions.begin(), positions.end());
  bytes.insert(bytes.end(), elements.begin(), elements.end());
  quality.hash = sha256(bytes);
  return quality;
}

}  // namespace fissura::structure
