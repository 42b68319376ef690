// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/tip_stress.hpp"

#include <cmath>

#include "structure/dynamics/element_fields.hpp"
#include "structure/dynamics/triangle.hpp"
#include "structure/fracture/connected_elements.hpp"

namespace fissura::structure {

InPlane<double> average_stress(const Mesh& mesh, const NodeElements& node_elements, const Body& body,
                               const Elasticity& moduli, const std::vector<double>& displacement, const HalfDisc& disc) {
  InPlane<double> sum{0, 0, 0}, nearest{0, 0, 0};
  double weights = 0, nearest_weights = 0;
  const auto add = [&](ElementIndex element, double weight, InPlane<double>& to, double& total) {
    const InPlane<double> stress = undamaged_stress(mesh, body, moduli, element, displacement).in_plane;
    const double pressure = body.in_situ[element].pore_pressure;
    to.xx += weight * (stress.xx - pressure);
    to.yy += weight * (stress.yy - pressure);
    to.xy += weight * stress.xy;
    total += weight;
  };
  for (const ElementIndex element : connected_elements(mesh, node_elements, disc.node, disc.centre, disc.radius)) {
    const Point at = centroid(mesh, element);
    const double x = at[0] - disc.centre[0], y = at[1] - disc.centre[1];
    if (x * disc.direction[0] + y * disc.direction[1] <= 0) continue;
    const double squared = x * x + y * y, area = triangle(mesh, element).area;
    if (squared > disc.radius * disc.radius) continue;
    add(element, area * std::exp(-squared / (2 * disc.width * disc.width)), sum, weights);
  }
  if (weights == 0) {
    for (const ElementIndex element : node_elements.of(disc.node))
      add(element, triangle(mesh, element).area, nearest, nearest_weights);
    sum = nearest;
    weights = nearest_weights;
  }
  return {sum.xx / weights, sum.yy / weights, sum.xy / weights};
}

}  // namespace fissura::structure
