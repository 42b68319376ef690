// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "structure/material/elasticity.hpp"
#include "structure/mesh/mesh.hpp"

/// Elastic rock at rest, as the exact answer of its triangles.
namespace fissura::structure::fakes {

/// What happens to the faces of a contact unit.
struct Faces {
  bool together = true;           ///< they move together, `apart` from one another
  std::array<double, 2> apart{};  ///< displacement of plus less that of minus [m]
  std::array<double, 2>
      traction{};  ///< force on plus, and against it on minus, per length of the unit, if not together [Pa]
};

/// Displacements [m, interleaved] under these conditions, one for each unit, all sides held.
std::vector<double> displacement_at_rest(const Mesh& mesh, const Elasticity& moduli,
                                         const std::vector<Faces>& faces);

/// Every unit of a line open under a pressure [Pa], along the normal of each face.
void press(const Mesh& mesh, std::uint32_t line, double pressure, std::vector<Faces>& faces);

}  // namespace fissura::structure::fakes
