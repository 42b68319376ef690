// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "common/case/case.hpp"
#include "structure/mesh/size_field.hpp"

namespace fissura::structure {

/// A part of the domain that may hold a stretch of uniform target size.
struct UniformPart {
  double size = 0;                                  ///< target edge length [m]
  double west = 0, east = 0, south = 0, north = 0;  ///< a rectangle around it [m]
};

/// Rectangles around the corridor of each line, the refinements, and the whole domain at the far size.
std::vector<UniformPart> uniform_parts(const Case& given, std::span<const SizedSegment> lines);

/// The points inside a part of the hexagonal lattice through the origin with its size as edge length, one
/// family of edges at `angle` [rad], counter-clockwise from x. Row by row.
std::vector<Point> hexagonal_lattice(const UniformPart& part, double angle);

}  // namespace fissura::structure
