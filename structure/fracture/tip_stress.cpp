// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/tip_stress.hpp"

#include <cmath>

#include "structure/dynamics/element_fields.hpp"
#include "structure/dynamics/triangle.hpp"
#include "structure/fracture/connected_elements.hpp"
#include "structure/fracture/triangle_integral.hpp"

namespace fissura::structure {

namespace {

double weight_at(const HalfDisc& disc, const Point& at) {
  const double x = at[0] - disc.centre[0], y = at[1] - disc.centre[1];
  const double ahead = x * disc.direction[0] + y * disc.direction[1], squared = x * x + y * y;
  if (ahead <= 0 || squared > disc.radius * disc.radius) return 0;
  const double gaussian = std::exp(-squared / (2 * disc.width * disc.width));
  return disc.weighting == HalfDisc::Weighting::ahead ? ahead * ahead * gaussian : gaussian;
}

}  // namespace

InPlane<double> average_stress(const Mesh& mesh, const NodeElements& node_elements, const Body& body,
                               const Elasticity& moduli, const std::vector<double>& displacement,
                               const HalfDisc& disc) {
  InPlane<double> sum{0, 0, 0};
  double weights = 0;
  const auto add = [&](ElementIndex element, double weight) {
    const InPlane<double> stress = undamaged_stress(mesh, body, moduli, element, displacement).in_plane;
    const double pressure = body.in_situ[element].pore_pressure;
    sum.xx += weight * (stress.xx - pressure);
    sum.yy += weight * (stress.yy - pressure);
    sum.xy += weight * stress.xy;
    weights += weight;
  };
  for (const ElementIndex element :
       connected_elements(mesh, node_elements, disc.node, disc.centre, disc.radius)) {
    const auto& [a, b, c] = mesh.elements[element];
    const std::array<Point, 3> corner{mesh.position[a], mesh.position[b], mesh.position[c]};
    if (const double weight = integral_over(corner, triangle(mesh, element).area,
                                            [&](const Point& at) { return weight_at(disc, at); });
        weight > 0)
      add(element, weight);
  }
  if (weights == 0)
    for (const ElementIndex element : node_elements.of(disc.node)) add(element, triangle(mesh, element).area);
  return {sum.xx / weights, sum.yy / weights, sum.xy / weights};
}

}  // namespace fissura::structure
