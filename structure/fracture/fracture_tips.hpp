// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "structure/joints/joint_state.hpp"
#include "structure/mesh/mesh.hpp"

namespace fissura::structure {

/// A place from which a fracture can grow into the rock.
struct FractureTip {
  enum class Kind {
    end,          ///< of an open line or of what grew
    natural_end,  ///< of a natural fracture that has slid or opened
    crossing  ///< where a fracture joined a natural one that it may cross: on the natural fracture's far side
  };
  Kind kind = Kind::end;
  VertexIndex vertex = 0;             ///< not split, but at a crossing
  VertexIndex previous = 0;           ///< at the other end of `edge`
  EdgeIndex edge = 0;                 ///< the last one of the fracture that grows
  NodeIndex node = 0;                 ///< of `vertex`, on the side of the growth
  std::uint32_t line = 0;             ///< of that edge, index into Mesh::lines
  Point position{};                   ///< [m]
  std::array<double, 2> direction{};  ///< of the growth so far, unit vector
};

/// Ends of open lines and of all that grew, ascending in the vertex.
std::vector<FractureTip> fracture_tips(const Mesh& mesh);

/// Ends of natural fractures whose last faces have slid by more than `active_slip` or parted, ascending in
/// the vertex. Those at rest load the rock at their ends no more than its surroundings.
std::vector<FractureTip> natural_ends(const Mesh& mesh, const Joints& joints);
inline constexpr double active_slip = 1e-6;  ///< [m]

/// Fluid pressure that pushes the faces next to a tip apart [Pa]: the least at the last four open places
/// behind it on the fracture's own faces, 0 while those next to the tip are closed. Fluid loses pressure on
/// its way to the tip. Where it seems not to, fluid has seeped between closed faces, or faces that have just
/// opened strike back on it; either would let segments run ahead of any opening.
double adjacent_pressure(const Mesh& mesh, const Joints& joints, const FractureTip& tip);

/// Direction in which the fracture at `tip` has come, over at most `edges` edges and not beyond a junction:
/// unit vector along the chord. The direction of the last edge alone is that of the vertex it was led to.
std::array<double, 2> mean_direction(const Mesh& mesh, const FractureTip& tip, int edges);

}  // namespace fissura::structure
