// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/planar_mesh.hpp"

#include "common/exchange/participant.hpp"
#include "structure/mesh/interior_points.hpp"
#include "structure/mesh/line_arrangement.hpp"
#include "structure/mesh/prescribed_points.hpp"
#include "structure/mesh/relax_points.hpp"

namespace fissura::structure {

PlanarMesh mesh_domain(const Case& given) {
  const LineArrangement lines = arrange_lines(given);
  const SizeField field(given.mesh, stretches(lines, given), growing_tips(lines, given));
  PrescribedPoints prescribed = prescribe_points(lines, field, given);
  const MeshRegion region(given.domain, field);

  note_progress("mesh");
  PointCloud cloud = place_interior_points(lines, prescribed, region, given);
  std::vector<PointTriple> triangles = relax_points(cloud, prescribed.edges, region);
  return {std::move(cloud.points), std::move(triangles), std::move(prescribed.line_edges)};
}

}  // namespace fissura::structure
