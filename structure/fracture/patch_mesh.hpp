// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "structure/fracture/patch_outline.hpp"
#include "structure/fracture/tip_size_field.hpp"

namespace fissura::structure {

/// A patch triangulated anew.
struct PatchMesh {
  std::vector<Point> points;        ///< those of the outline that must stay, new line points, then free ones [m]
  std::size_t fixed = 0;            ///< points that were given and have not moved
  std::vector<PointTriple> triangles;  ///< counter-clockwise, filling the patch
  std::vector<std::uint32_t> outline_point;  ///< of each free point: the free point of the outline it was, or `added`
  double smallest_angle = 0;        ///< [rad]
  double smallest_altitude = 0;     ///< [m]

  static constexpr std::uint32_t added = 0xffffffffu;
};

/// Triangulates the patch with the new line `line` (a polyline; its first point and any other one that is a point of the outline are
/// those) as edges. No edge of the outline or of a fracture is split or moved. Points are added where triangles are larger than `field`,
/// removed near the line and where they crowd, and moved until the triangles are good: Delaunay refinement by circumcentres, optimal
/// Delaunay smoothing (Chen & Holst 2011), then a search around the worst triangles.
/// @returns nothing if the line leaves the patch, meets its outline, or a triangle has an altitude below `least_altitude` [m]
std::optional<PatchMesh> mesh_patch(const PatchOutline& outline, const std::vector<Point>& line, const TipSizeField& field,
                                    double least_altitude);

}  // namespace fissura::structure
