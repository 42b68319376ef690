// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "structure/mesh/triangulate.hpp"

namespace fissura::structure {

/// A mesh edge on a fracture line, in the direction of the line.
struct LineEdge {
  std::uint32_t begin = 0, end = 0;  ///< points
  std::uint32_t line = 0;            ///< index into Case::fractures
};

/// The triangulated domain before it is cut along the fracture lines.
struct PlanarMesh {
  std::vector<Point> points;         ///< [m]
  std::vector<PointTriple> triangles;   ///< counter-clockwise; together they fill the domain
  std::vector<LineEdge> line_edges;  ///< line by line, along each line
};

/// A conforming triangulation of the domain in four steps: the points of lines and sides, which stay where
/// they are (prescribed_points.hpp); the interior points (interior_points.hpp); their relaxation
/// (relax_points.hpp); the constrained Delaunay triangulation (triangulate.hpp). The same case gives the same
/// bits; another mesh.seed gives other interior points beyond the corridor. Throws InputError for lines that
/// cannot be meshed (line_arrangement.hpp).
PlanarMesh mesh_domain(const Case& given);

}  // namespace fissura::structure
