// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/joints/sliding_limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/errors.hpp"

namespace fissura::structure {

std::vector<double> sliding_limits(const Mesh& mesh) {
  std::vector<double> limits(mesh.units.size(), std::numeric_limits<double>::infinity());
  for (const FractureEdge& edge : mesh.edges)
    for (const UnitIndex unit : edge.unit)
      if (unit != no_unit) limits[unit] = std::min(limits[unit], edge.length / 2);
  return limits;
}

void require_facing_pairs(const Mesh& mesh, const Joints& joints, const std::vector<double>& limits) {
  for (UnitIndex unit = 0; unit < mesh.units.size(); ++unit) {
    const JointState& state = joints.state[unit];
    const double slid = std::abs(state.sliding + state.sliding_at_rest);
    if (!(slid > limits[unit])) continue;
    const Point& at = mesh.vertices[mesh.units[unit].vertex].position;
    throw SolverError(fmt::format(
        "fracture '{}' has slid by {:.6g} m at ({:.6g}, {:.6g}) m, more than half of its shorter edge there, "
        "{:.6g} m: its nodes no longer face each other; make mesh.{} larger than {:.6g} m",
        mesh.lines[mesh.units[unit].line].name, slid, at[0], at[1], limits[unit],
        joints.properties[unit].kind == FractureKind::natural ? "natural_size" : "fracture_size", 2 * slid));
  }
}

}  // namespace fissura::structure
