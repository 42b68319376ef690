// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "structure/mesh/mesh.hpp"

/// Meshes for tests and benchmarks of the structure that need no mesh generator.
namespace fissura::structure::fakes {

/// A rectangle centred on the origin, cut into columns x rows cells of two triangles with alternating
/// diagonals.
struct Grid {
  double width = 0, height = 0;  ///< [m]
  int columns = 0, rows = 0;
  double jitter = 0;  ///< interior nodes move by up to this fraction of the cell size [-]
  std::uint64_t seed = 1;
};

/// Elements in Hilbert order, nodes numbered by first touch. Nodes at y = 0 keep their y.
Mesh jittered_mesh(const Grid& grid);

/// The same with the nodes of |x| < half_length at y = 0 doubled: a fracture line in the direction of +x with
/// its tips at the first nodes outside. Needs an even number of rows.
Mesh mesh_with_line(const Grid& grid, double half_length);

/// The same mesh with elements and nodes in random order.
Mesh shuffled(const Mesh& mesh, std::uint64_t seed);

}  // namespace fissura::structure::fakes
