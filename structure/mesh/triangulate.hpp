// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/case/case.hpp"

/// The door to CGAL.
namespace fissura::structure {

using PointTriple = std::array<std::uint32_t, 3>;
using PointPair = std::array<std::uint32_t, 2>;

/// The constrained Delaunay triangulation of `points` [m] over their convex hull: every pair in `edges`
/// (indices into `points`) is an edge of it, and no point is added. Triangles name their points
/// counter-clockwise, lowest index first, in an order that depends on the arguments only. Exact predicates,
/// constructions in double (CGAL, package 2D Triangulations). Throws SolverError if two points coincide, two
/// edges cross or a point lies inside an edge.
std::vector<PointTriple> triangulate(std::span<const Point> points, std::span<const PointPair> edges);

}  // namespace fissura::structure
