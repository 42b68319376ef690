// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/node_loads.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "common/errors.hpp"
#include "structure/dynamics/in_situ.hpp"
#include "structure/dynamics/triangle.hpp"

namespace fissura::structure {

namespace {

constexpr std::array<std::array<double, 2>, 4> outward_normal{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

// Digits a case file is expected to carry: a mismatch of body force and stress gradient below this is
// rounding.
constexpr double equilibrium_tolerance = 1e-8;

}  // namespace

NodeLoads::NodeLoads(const Mesh& mesh, const NodeElements& elements, const Case& settings)
    : mesh_(mesh),
      elements_(elements),
      settings_(settings),
      boundary_{&settings.boundary.west, &settings.boundary.east, &settings.boundary.south,
                &settings.boundary.north},
      sides_(mesh.position.size(), 0),
      on_fracture_(mesh.position.size(), 0) {
  for (int side = 0; side < 4; ++side)
    for (const NodeIndex node : mesh.side_nodes[side])
      sides_[node] = static_cast<std::uint8_t>(sides_[node] | 1 << side);
  for (const ContactUnit& unit : mesh.units) on_fracture_[unit.minus] = on_fracture_[unit.plus] = 1;
}

double NodeLoads::mass(NodeIndex node) const {
  double mass = 0;
  for (const ElementIndex element : elements_.of(node))
    mass += settings_.rock.density * triangle(mesh_, element).area / 3;
  return mass;
}

NodeConstraint NodeLoads::constraint(NodeIndex node) const {
  NodeConstraint constraint;
  bool fixed = false;
  for (int side = 0; side < 4; ++side) {
    if (!on_side(node, side)) continue;
    const int normal_axis = side / 2;
    const Boundary& here = *boundary_[side];
    if (here.kind == BoundaryKind::fixed) fixed = true;
    if (here.kind == BoundaryKind::roller) constraint.held[normal_axis] = true;
    if (here.kind != BoundaryKind::displacement) continue;
    if (!constraint.prescribed)
      constraint.prescribed = PrescribedNode{node, here.value, here.ramp};
    else
      constraint.prescribed->displacement[normal_axis] = here.value[normal_axis];
  }
  if (fixed) return {{true, true}, std::nullopt};
  if (!constraint.prescribed) return constraint;
  for (int axis = 0; axis < 2; ++axis)
    if (constraint.held[axis]) constraint.prescribed->displacement[axis] = 0;
  constraint.held = {true, true};
  return constraint;
}

std::array<double, 2> NodeLoads::external_force(NodeIndex node, const std::array<bool, 2>& held,
                                                const std::vector<InSituElement>& in_situ) const {
  std::array<double, 2> force{};
  for (const ElementIndex element : elements_.of(node)) {
    const double share = settings_.rock.density * triangle(mesh_, element).area / 3;
    for (int axis = 0; axis < 2; ++axis) force[axis] += share * settings_.in_situ.body_acceleration[axis];
  }
  add_in_situ_tractions(node, force);
  const InSituForce internal = in_situ_force(node, in_situ);
  for (int axis = 0; axis < 2; ++axis) {
    const double residual = internal.exact[axis] + force[axis];
    if (on_fracture_[node] || held[axis]) {
      force[axis] += internal.exact[axis] - internal.stored[axis];
      continue;
    }
    const double rounding = equilibrium_tolerance * internal.scale;
    if (!(std::abs(residual) <= rounding))
      throw SolverError(fmt::format(
          "the in-situ stress, pore pressure and body force of the case are out of equilibrium: node {} at "
          "({} m, {} m) feels {} N/m in {} at zero displacement, where at most {} N/m of rounding was "
          "expected",
          node, mesh_.position[node][0], mesh_.position[node][1], residual, axis == 0 ? "x" : "y", rounding));
    force[axis] = -internal.stored[axis];
  }
  add_case_tractions(node, force);
  return force;
}

// The sides are straight, so an element edge with both ends on a side lies in it.
std::vector<NodeLoads::SideEdge> NodeLoads::side_edges(NodeIndex node) const {
  std::vector<SideEdge> edges;
  if (sides_[node] == 0) return edges;
  for (const ElementIndex element : elements_.of(node))
    for (int corner = 0; corner < 3; ++corner)
      for (int side = 0; side < 4; ++side) {
        const NodeIndex a = mesh_.elements[element][corner], b = mesh_.elements[element][(corner + 1) % 3];
        if ((a != node && b != node) || !on_side(a, side) || !on_side(b, side)) continue;
        const Point &p = mesh_.position[a], &q = mesh_.position[b];
        edges.push_back({node, a == node ? b : a, side, std::hypot(q[0] - p[0], q[1] - p[1])});
      }
  return edges;
}

// Consistent forces of a traction that varies linearly along the edge: length (2 t_here + t_there) / 6.
void NodeLoads::add_in_situ_tractions(NodeIndex node, std::array<double, 2>& force) const {
  for (const SideEdge& edge : side_edges(node)) {
    const auto& normal = outward_normal[edge.side];
    const auto near = traction(total_stress(in_situ_state(settings_, mesh_.position[edge.here])), normal);
    const auto far = traction(total_stress(in_situ_state(settings_, mesh_.position[edge.there])), normal);
    for (int axis = 0; axis < 2; ++axis) force[axis] += edge.length * (2 * near[axis] + far[axis]) / 6;
  }
}

void NodeLoads::add_case_tractions(NodeIndex node, std::array<double, 2>& force) const {
  for (const SideEdge& edge : side_edges(node)) {
    if (boundary_[edge.side]->kind != BoundaryKind::traction) continue;
    for (int axis = 0; axis < 2; ++axis) force[axis] += 0.5 * edge.length * boundary_[edge.side]->value[axis];
  }
}

NodeLoads::InSituForce NodeLoads::in_situ_force(NodeIndex node,
                                                const std::vector<InSituElement>& in_situ) const {
  InSituForce force{{}, {}, std::numeric_limits<double>::min()};
  for (const ElementIndex element : elements_.of(node)) {
    const auto shape = triangle(mesh_, element);
    const auto state = in_situ_state(settings_, centroid(mesh_, element));
    const auto& rounded = in_situ[element];
    const InPlane<double> exact = total_stress(state);
    const double pressure = rounded.pore_pressure;
    const InPlane<double> stored{rounded.xx - pressure, rounded.yy - pressure, rounded.xy};
    const double magnitude = std::abs(state.stress.xx) + std::abs(state.stress.yy) +
                             std::abs(state.stress.xy) + std::abs(state.pore_pressure);
    for (int i = 0; i < 3; ++i) {
      if (mesh_.elements[element][i] != node) continue;
      const std::array<double, 2> weight{shape.area * shape.slope[i][0], shape.area * shape.slope[i][1]};
      const auto f = traction(exact, weight), g = traction(stored, weight);
      for (int axis = 0; axis < 2; ++axis) {
        force.exact[axis] -= f[axis];
        force.stored[axis] -= g[axis];
      }
      force.scale += magnitude * std::hypot(weight[0], weight[1]);
    }
  }
  return force;
}

}  // namespace fissura::structure
