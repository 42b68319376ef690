// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "structure/material/elasticity.hpp"
#include "structure/mesh/mesh.hpp"

namespace fissura::structure {

/// A straight piece of a fracture whose faces have moved apart or along one another: displacement of the face
/// on the left-hand side (of the direction from begin to end) relative to the other one, linear between the
/// ends.
struct DisplacementJump {
  Point begin{}, end{};                        ///< [m]
  std::array<double, 2> at_begin{}, at_end{};  ///< jump, x and y [m]
};

/// Stress that the jump causes at `place` in an infinite plane (plane strain), tension positive [Pa]. The
/// piece is cut into `parts` of constant jump: a jump D from z_a to z_b is a dislocation D at z_a and -D at
/// z_b, of Kolosov-Muskhelishvili potentials
///   phi' = g / (z - z_a),  psi' = conj(g) / (z - z_a) + g conj(z_a) / (z - z_a)^2,  g = i E' D / (8 pi),
/// with sigma_xx + sigma_yy = 4 Re phi', sigma_yy - sigma_xx + 2 i sigma_xy = 2 (conj(z) phi'' + psi').
/// N. I. Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity (1953); S. L. Crouch,
/// Int. J. Numer. Meth. Eng. 10 (1976) 301. Near the piece it is good at distances beyond the length of a
/// part.
/// @param plane_strain_modulus  E' [Pa]
InPlane<double> stress_of_jump(const DisplacementJump& jump, int parts, double plane_strain_modulus,
                               const Point& place);

}  // namespace fissura::structure
