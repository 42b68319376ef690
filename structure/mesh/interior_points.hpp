// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "structure/mesh/mesh_region.hpp"
#include "structure/mesh/point_cloud.hpp"
#include "structure/mesh/prescribed_points.hpp"

namespace fissura::structure {

/// Fills the domain with points about h(x) apart.
///
/// On prescribed paths they stand, within the corridor of each straight piece of line, in rows parallel to
/// it, staggered by half an edge, so that the triangles are equilateral and mirrored in the line; the rows
/// run on beyond the ends. Where rows of two pieces meet, each point belongs to the nearer piece. Where
/// fractures grow freely there are no rows: they would favour growth straight ahead. With a lattice angle
/// there are, in place of rows, points of a hexagonal lattice wherever h is uniform. Points with a full ring
/// of six such neighbours are held.
///
/// Beyond, the points spread from the front of those placed already: around each, six candidates at the
/// distance h, kept if no other point is too near (advancing node positioning after Slak and Kosec, SIAM J.
/// Sci. Comput. 41 (2019) A3202, with hexagonal candidates). mesh.seed jitters their direction and distance;
/// where fractures grow freely it turns each hexagon at random.
PointCloud place_interior_points(const LineArrangement& lines, const PrescribedPoints& prescribed,
                                 const MeshRegion& region, const Case& given);

}  // namespace fissura::structure
