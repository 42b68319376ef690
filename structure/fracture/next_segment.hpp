// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "structure/fracture/fracture_tips.hpp"
#include "structure/material/mohr_circle.hpp"

namespace fissura::structure {

/// Where a segment ahead of a tip ends.
struct SegmentEnd {
  enum class Kind {
    rock,      ///< a new vertex inside the rock
    fracture,  ///< an existing fracture vertex: the two join
    boundary   ///< a mesh node on a side of the domain: the fracture breaks through
  };
  Kind kind = Kind::rock;
  Point position{};        ///< [m]
  VertexIndex vertex = 0;  ///< of Kind::fracture
  NodeIndex node = 0;      ///< of Kind::boundary
};

/// Why a segment is not inserted although the rock ahead of the tip has failed.
enum class Obstacle {
  own_fracture,       ///< it would turn back on itself
  no_vertex_to_join,  ///< it would cross a fracture that has no vertex within reach at a fair angle
  boundary_too_coarse
};

struct NextSegment {
  std::optional<SegmentEnd> end;
  std::optional<Obstacle> obstacle;  ///< set if `end` is not
};

/// Ends the segment of this direction (unit vector) and length [m] from `tip`. `h` is the element size at the
/// tip [m], the measure of all distances:
///  - it ends on another fracture, at the vertex most nearly ahead, if it would cross it or end too near to
///  it; the other may be connected
///    to its own one elsewhere;
///  - it does not turn back on the edges next to the tip;
///  - it ends on a side of the domain, at the mesh node most nearly ahead, if it would leave too little rock
///  before it.
NextSegment next_segment(const Mesh& mesh, const Domain& domain, const FractureTip& tip,
                         const std::array<double, 2>& direction, double length, double h);

/// Direction of growth under an averaged stress, perpendicular to its greatest principal stress: of the two,
/// that which turns least from `before`, turned by at most `turn_limit` [rad].
std::array<double, 2> growth_direction(const InPlane<double>& stress, const std::array<double, 2>& before,
                                       double turn_limit);

}  // namespace fissura::structure
