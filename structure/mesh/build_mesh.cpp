// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/build_mesh.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/errors.hpp"
#include "common/exchange/participant.hpp"
#include "structure/mesh/order.hpp"
#include "structure/mesh/planar_mesh.hpp"
#include "structure/mesh/split_fractures.hpp"

namespace fissura::structure {
namespace {

void list_side_nodes(Mesh& mesh, const Domain& domain) {
  const auto side = [&](Side which) -> auto& {
    return mesh.side_nodes[static_cast<std::size_t>(which)];
  };
  for (NodeIndex node = 0; node < mesh.position.size(); ++node) {
    const auto [x, y] = mesh.position[node];
    if (x == -domain.width / 2) side(Side::west).push_back(node);
    if (x == domain.width / 2) side(Side::east).push_back(node);
    if (y == -domain.height / 2) side(Side::south).push_back(node);
    if (y == domain.height / 2) side(Side::north).push_back(node);
  }
}

void check_areas(const Mesh& mesh) {
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element)
    if (const double area = element_area(mesh, element); !(std::isfinite(area) && area > 0)) {
      const Point corner = mesh.position[mesh.elements[element][0]];
      throw SolverError(
          fmt::format("the mesh has an element of area {:.3g} m2 at ({:.6g}, {:.6g}) m; every area must be "
                      "positive",
                      area, corner[0], corner[1]));
    }
}

Case without_unmeshed_lines(Case given) {
  if (given.growth.path == PathRule::free)
    std::erase_if(given.fractures, [](const FractureLine& line) { return line.kind == FractureKind::intact; });
  return given;
}

}  // namespace

Mesh build_mesh(const Case& run_case) {
  const Case given = without_unmeshed_lines(run_case);
  Mesh mesh = split_fractures(mesh_domain(given), given.fractures);
  mesh.lines = given.fractures;
  note_progress("mesh");
  order(mesh);
  list_side_nodes(mesh, given.domain);
  check_areas(mesh);
  return mesh;
}

}  // namespace fissura::structure
