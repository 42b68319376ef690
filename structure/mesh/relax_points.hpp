// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "structure/mesh/mesh_region.hpp"
#include "structure/mesh/point_cloud.hpp"
#include "structure/mesh/triangulate.hpp"

namespace fissura::structure {

/// Moves, adds and removes the points of `cloud` that are not held until its triangulation with `edges` kept
/// has good triangles of size h(x), and returns that triangulation.
///
/// Rounds of: split edges much longer than h, remove points at edges much shorter, and move every point to
/// the mean of the circumcentres around it, weighted by area / h^4 (optimal Delaunay triangulation: Chen and
/// Holst, Comput. Methods Appl. Mech. Eng. 200 (2011) 967; splitting and removal as in Bossen and Heckbert,
/// 5th Int. Meshing Roundtable (1996) 63). Then points around angles that are still small search the place of
/// the largest smallest angle (Freitag and Ollivier-Gooch, Int. J. Numer. Methods Eng. 40 (1997) 3979). No
/// point crosses a line or a side.
std::vector<PointTriple> relax_points(PointCloud& cloud, std::span<const PointPair> edges,
                                   const MeshRegion& region);

}  // namespace fissura::structure
