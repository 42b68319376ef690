// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/joints/joint_state.hpp"

namespace fissura::structure {

/// How far the faces of every unit may slide: half its shorter adjoining edge. Beyond it the nodes that face
/// each other would be other pairs than those that act on each other. [m]
std::vector<double> sliding_limits(const Mesh& mesh);

/// Throws SolverError, naming fracture, place, slip and limit, if a unit has slid farther, what it slid
/// before time 0 included.
void require_facing_pairs(const Mesh& mesh, const Joints& joints, const std::vector<double>& limits);

}  // namespace fissura::structure
