// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "structure/mesh/mesh.hpp"

/// Meshes whose edges point where a test wants them.
namespace fissura::structure::fakes {

/// A rectangle centred on the origin, filled with equilateral triangles; only along its sides and the notch
/// they are others.
struct Lattice {
  double width = 0, height = 0;  ///< [m]
  double edge = 0;               ///< [m]
  double angle = 0;              ///< of one of the three families of edges, counter-clockwise from x [rad]
  double notch = 0;              ///< length of a slit along y = 0, from the west side on [m]; 0 for none
};

/// Elements and nodes in memory order. The two faces of the notch have nodes of their own and do not touch.
Mesh lattice_mesh(const Lattice& lattice);

}  // namespace fissura::structure::fakes
