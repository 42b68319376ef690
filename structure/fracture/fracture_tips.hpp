// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "structure/joints/joint_state.hpp"
#include "structure/mesh/mesh.hpp"

namespace fissura::structure {

/// The end of a fracture inside the rock: a vertex on one fracture edge, not split.
struct FractureTip {
  VertexIndex vertex = 0;             ///< the unsplit one
  VertexIndex previous = 0;           ///< at the other end of its edge
  NodeIndex node = 0;                 ///< of `vertex`
  std::uint32_t line = 0;             ///< of that edge, index into Mesh::lines
  Point position{};                   ///< [m]
  std::array<double, 2> direction{};  ///< from `previous`, unit vector
};

/// Tips of open lines and of all that grew, ascending in the vertex. Natural fractures have none.
std::vector<FractureTip> fracture_tips(const Mesh& mesh);

/// Fluid pressure that pushes the faces next to a tip apart [Pa]: the least at the last four open vertices behind it, 0 while the faces at
/// `tip.previous` are closed. Fluid loses pressure on its way to the tip. Where it seems not to, fluid has seeped between closed faces, or
/// faces that have just opened strike back on it; either would let segments run ahead of any opening.
double adjacent_pressure(const Mesh& mesh, const Joints& joints, const FractureTip& tip);

}  // namespace fissura::structure
