// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "structure/mesh/mesh.hpp"

namespace fissura::structure {

/// What a mesh costs and how good it is. The stable time step is proportional to the smallest altitude.
struct MeshQuality {
  std::size_t elements = 0, nodes = 0;
  double smallest_angle = 0;                   ///< of any element [degrees]
  double smallest_altitude = 0;                ///< of any element [m]
  double smallest_edge = 0, largest_edge = 0;  ///< [m]
  std::string hash;                            ///< SHA-256 of positions and elements: equal for equal bits
};
MeshQuality measure(const Mesh& mesh);

}  // namespace fissura::structure
