// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "common/errors.hpp"
#include "structure/dynamics/in_situ.hpp"
#include "structure/dynamics/triangle.hpp"

namespace fissura::structure {

namespace {

constexpr std::array<std::array<double, 2>, 4> outward_normal{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
constexpr std::array<const char*, 4> side_name{"west", "east", "south", "north"};

// Digits a case file is expected to carry: a mismatch of body force and stress gradient below this is
// rounding.
constexpr double equilibrium_tolerance = 1e-8;

std::array<const Boundary*, 4> boundaries(const Case& settings) {
  const auto& sides = settings.boundary;
  return {&sides.west, &sides.east, &sides.south, &sides.north};
}

std::vector<std::array<bool, 4>> sides_of_nodes(const Mesh& mesh) {
  std::vector<std::array<bool, 4>> on_side(mesh.position.size(), {false, false, false, false});
  for (int side = 0; side < 4; ++side)
    for (const NodeIndex node : mesh.side_nodes[side]) on_side[node][side] = true;
  return on_side;
}

void add_masses_and_body_force(const Mesh& mesh, const Case& settings, Body& body) {
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const double share = settings.rock.density * triangle(mesh, element).area / 3;
    for (const NodeIndex node : mesh.elements[element]) {
      body.mass[node] += share;
      for (int axis = 0; axis < 2; ++axis)
        body.external_force[2 * node + axis] += share * settings.in_situ.body_acceleration[axis];
    }
  }
}

struct BoundaryEdge {
  std::array<NodeIndex, 2> node{};
  int side = 0;
  double length = 0;
};

// The sides are straight, so an element edge with both ends on a side lies in it.
std::vector<BoundaryEdge> boundary_edges(const Mesh& mesh) {
  const auto on_side = sides_of_nodes(mesh);
  std::vector<BoundaryEdge> edges;
  for (const auto& element : mesh.elements)
    for (int corner = 0; corner < 3; ++corner)
      for (int side = 0; side < 4; ++side) {
        const NodeIndex a = element[corner], b = element[(corner + 1) % 3];
        if (!on_side[a][side] || !on_side[b][side]) continue;
        const Point &p = mesh.position[a], &q = mesh.position[b];
        edges.push_back({{a, b}, side, std::hypot(q[0] - p[0], q[1] - p[1])});
      }
  return edges;
}

// Consistent forces of a traction that varies linearly along the edge: length (2 t_here + t_there) / 6.
void add_in_situ_tractions(const Mesh& mesh, const Case& settings, Body& body) {
  for (const auto& edge : boundary_edges(mesh))
    for (int end = 0; end < 2; ++end) {
      const NodeIndex here = edge.node[end], there = edge.node[1 - end];
      const auto& normal = outward_normal[edge.side];
      const auto near = traction(total_stress(in_situ_state(settings, mesh.position[here])), normal);
      const auto far = traction(total_stress(in_situ_state(settings, mesh.position[there])), normal);
      for (int axis = 0; axis < 2; ++axis)
        body.external_force[2 * here + axis] += edge.length * (2 * near[axis] + far[axis]) / 6;
    }
}

void add_case_tractions(const Mesh& mesh, const Case& settings, Body& body) {
  const auto boundary = boundaries(settings);
  for (const auto& edge : boundary_edges(mesh)) {
    if (boundary[edge.side]->kind != BoundaryKind::traction) continue;
    for (const NodeIndex node : edge.node)
      for (int axis = 0; axis < 2; ++axis)
        body.external_force[2 * node + axis] += 0.5 * edge.length * boundary[edge.side]->value[axis];
  }
}

void set_in_situ_elements(const Mesh& mesh, const Case& settings, Body& body) {
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const auto state = in_situ_state(settings, centroid(mesh, element));
    body.in_situ[element] = {static_cast<float>(state.stress.xx), static_cast<float>(state.stress.yy),
                             static_cast<float>(state.stress.xy), static_cast<float>(state.out_of_plane),
                             static_cast<float>(state.pore_pressure)};
  }
}

void set_constraints(const Mesh& mesh, const Case& settings, Body& body) {
  const auto on_side = sides_of_nodes(mesh);
  const auto boundary = boundaries(settings);
  for (NodeIndex node = 0; node < mesh.position.size(); ++node) {
    std::array<bool, 2> held{false, false};
    bool fixed = false;
    std::optional<PrescribedNode> prescribed;
    for (int side = 0; side < 4; ++side) {
      if (!on_side[node][side]) continue;
      const int normal_axis = side / 2;
      const Boundary& here = *boundary[side];
      if (here.kind == BoundaryKind::fixed) fixed = true;
      if (here.kind == BoundaryKind::roller) held[normal_axis] = true;
      if (here.kind == BoundaryKind::displacement) {
        if (!prescribed)
          prescribed = PrescribedNode{node, here.value, here.ramp};
        else
          prescribed->displacement[normal_axis] = here.value[normal_axis];
      }
    }
    if (fixed) {
      held = {true, true};
    } else if (prescribed) {
      for (int axis = 0; axis < 2; ++axis)
        if (held[axis]) prescribed->displacement[axis] = 0;
      held = {true, true};
      body.prescribed.push_back(*prescribed);
    }
    for (int axis = 0; axis < 2; ++axis) body.inverse_mass[node][axis] = held[axis] ? 0 : 1 / body.mass[node];
  }
}

struct InSituForces {
  std::vector<double> exact, stored;  ///< internal, of the stress in double and in stored precision [N/m]
  std::vector<double> scale;          ///< sum of the magnitudes in them, per node [N/m]
};

InSituForces in_situ_forces(const Mesh& mesh, const Case& settings, const Body& body) {
  const std::size_t nodes = mesh.position.size();
  InSituForces forces{std::vector<double>(2 * nodes), std::vector<double>(2 * nodes),
                      std::vector<double>(nodes, std::numeric_limits<double>::min())};
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const auto shape = triangle(mesh, element);
    const auto state = in_situ_state(settings, centroid(mesh, element));
    const auto& rounded = body.in_situ[element];
    const InPlane<double> exact = total_stress(state);
    const double pressure = rounded.pore_pressure;
    const InPlane<double> stored{rounded.xx - pressure, rounded.yy - pressure, rounded.xy};
    const double magnitude = std::abs(state.stress.xx) + std::abs(state.stress.yy) +
                             std::abs(state.stress.xy) + std::abs(state.pore_pressure);
    for (int i = 0; i < 3; ++i) {
      const NodeIndex node = mesh.elements[element][i];
      const std::array<double, 2> weight{shape.area * shape.slope[i][0], shape.area * shape.slope[i][1]};
      const auto f = traction(exact, weight), g = traction(stored, weight);
      for (int axis = 0; axis < 2; ++axis) {
        forces.exact[2 * node + axis] -= f[axis];
        forces.stored[2 * node + axis] -= g[axis];
      }
      forces.scale[node] += magnitude * std::hypot(weight[0], weight[1]);
    }
  }
  return forces;
}

void balance_in_situ_state(const Mesh& mesh, const Case& settings, Body& body) {
  const auto forces = in_situ_forces(mesh, settings, body);
  std::vector<bool> on_fracture(mesh.position.size(), false);
  for (const NodeIndex node : joint_nodes(mesh)) on_fracture[node] = true;
  for (NodeIndex node = 0; node < mesh.position.size(); ++node) {
    for (int axis = 0; axis < 2; ++axis) {
      const std::size_t dof = 2 * node + axis;
      const double residual = forces.exact[dof] + body.external_force[dof];
      if (on_fracture[node] || body.inverse_mass[node][axis] == 0) {
        body.external_force[dof] += forces.exact[dof] - forces.stored[dof];
        continue;
      }
      if (!(std::abs(residual) <= equilibrium_tolerance * forces.scale[node]))
        throw SolverError(fmt::format(
            "the in-situ stress, pore pressure and body force of the case are out of equilibrium: node {} at "
            "({} m, {} "
            "m) feels {} N/m in {} at zero displacement, where at most {} N/m of rounding was expected",
            node, mesh.position[node][0], mesh.position[node][1], residual, axis == 0 ? "x" : "y",
            equilibrium_tolerance * forces.scale[node]));
      body.external_force[dof] = -forces.stored[dof];
    }
  }
}

void refuse_fractures_on_displaced_sides(const Mesh& mesh, const Case& settings) {
  const auto on_side = sides_of_nodes(mesh);
  const auto boundary = boundaries(settings);
  for (const auto& unit : mesh.units)
    for (const NodeIndex node : {unit.minus, unit.plus})
      for (int side = 0; side < 4; ++side)
        if (on_side[node][side] && boundary[side]->kind == BoundaryKind::displacement)
          throw InputError(
              fmt::format("fracture '{}' reaches the {} side, whose displacement is prescribed; it must end "
                          "inside the domain",
                          mesh.lines.at(unit.line).name, side_name[side]));
}

}  // namespace

std::vector<NodeIndex> joint_nodes(const Mesh& mesh) {
  std::vector<NodeIndex> nodes;
  for (const auto& unit : mesh.units) nodes.insert(nodes.end(), {unit.minus, unit.plus});
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

Body build_body(const Mesh& mesh, const Case& settings) {
  refuse_fractures_on_displaced_sides(mesh, settings);
  Body body;
  body.mass.resize(mesh.position.size());
  body.inverse_mass.resize(mesh.position.size());
  body.in_situ.resize(mesh.elements.size());
  body.external_force.resize(2 * mesh.position.size());
  add_masses_and_body_force(mesh, settings, body);
  add_in_situ_tractions(mesh, settings, body);
  set_in_situ_elements(mesh, settings, body);
  set_constraints(mesh, settings, body);
  balance_in_situ_state(mesh, settings, body);
  add_case_tractions(mesh, settings, body);
  return body;
}

}  // namespace fissura::structure
