// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/mesh/line_arrangement.hpp"
#include "structure/mesh/planar_mesh.hpp"
#include "structure/mesh/size_field.hpp"

namespace fissura::structure {

/// Points and edges that the mesh keeps as they are.
struct PrescribedPoints {
  std::vector<Point> points;         ///< of lines, then of the sides [m]
  std::vector<PointPair> edges;      ///< of lines, then of the sides
  std::vector<LineEdge> line_edges;  ///< those of lines, with the line
};

/// Number of equal edges on a straight stretch of length `length` [m]: the one whose edge length is nearest
/// to `size` [m].
int edge_count(double length, double size);

/// The pieces of an arrangement with the length of the edges on them.
std::vector<SizedSegment> stretches(const LineArrangement& lines, const Case& given);

/// The ends of open lines inside the domain that touch nothing, if fractures grow freely.
std::vector<Point> growing_tips(const LineArrangement& lines, const Case& given);

/// Divides each piece of the lines into equal edges of about the size along the line, or, where finer lines,
/// tips and refinements ask for shorter ones, into edges that follow the size field; and the four sides of
/// the domain, between corners and line ends, into edges that follow it too.
PrescribedPoints prescribe_points(const LineArrangement& lines, const SizeField& field, const Case& given);

}  // namespace fissura::structure
