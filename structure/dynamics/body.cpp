// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/body.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/errors.hpp"
#include "structure/dynamics/in_situ.hpp"
#include "structure/dynamics/node_loads.hpp"
#include "structure/dynamics/triangle.hpp"

namespace fissura::structure {

namespace {

constexpr std::array<const char*, 4> side_name{"west", "east", "south", "north"};

InSituElement in_situ_element(const Mesh& mesh, const Case& settings, ElementIndex element) {
  const auto state = in_situ_state(settings, centroid(mesh, element));
  return {static_cast<float>(state.stress.xx), static_cast<float>(state.stress.yy),
          static_cast<float>(state.stress.xy), static_cast<float>(state.out_of_plane),
          static_cast<float>(state.pore_pressure)};
}

void set_node(const NodeLoads& loads, NodeIndex node, Body& body) {
  const NodeConstraint constraint = loads.constraint(node);
  body.mass[node] = loads.mass(node);
  const bool used = body.mass[node] > 0;
  for (int axis = 0; axis < 2; ++axis)
    body.inverse_mass[node][axis] = constraint.held[axis] || !used ? 0 : 1 / body.mass[node];
  const auto force =
      used ? loads.external_force(node, constraint.held, body.in_situ) : std::array<double, 2>{};
  for (int axis = 0; axis < 2; ++axis) body.external_force[2 * std::size_t{node} + axis] = force[axis];
  if (constraint.prescribed && used) body.prescribed.push_back(*constraint.prescribed);
}

void refuse_fractures_on_displaced_sides(const Mesh& mesh, const Case& settings) {
  const std::array<const Boundary*, 4> boundary{&settings.boundary.west, &settings.boundary.east,
                                                &settings.boundary.south, &settings.boundary.north};
  for (int side = 0; side < 4; ++side) {
    if (boundary[side]->kind != BoundaryKind::displacement) continue;
    std::vector<bool> displaced(mesh.position.size(), false);
    for (const NodeIndex node : mesh.side_nodes[side]) displaced[node] = true;
    for (const ContactUnit& unit : mesh.units)
      if (displaced[unit.minus] || displaced[unit.plus])
        throw InputError(
            fmt::format("fracture '{}' reaches the {} side, whose displacement is prescribed; it must end "
                        "inside the domain",
                        mesh.lines.at(unit.line).name, side_name[side]));
  }
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
  const NodeElements elements(mesh);
  const NodeLoads loads(mesh, elements, settings);
  Body body;
  body.mass.resize(mesh.position.size());
  body.inverse_mass.resize(mesh.position.size());
  body.external_force.resize(2 * mesh.position.size());
  body.in_situ.reserve(mesh.elements.size());
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element)
    body.in_situ.push_back(in_situ_element(mesh, settings, element));
  for (NodeIndex node = 0; node < mesh.position.size(); ++node) set_node(loads, node, body);
  return body;
}

void update_body(const Mesh& mesh, const NodeElements& elements, const Case& settings,
                 const MeshChange& change, Body& body) {
  refuse_fractures_on_displaced_sides(mesh, settings);
  body.mass.resize(mesh.position.size());
  body.inverse_mass.resize(mesh.position.size());
  body.external_force.resize(2 * mesh.position.size());
  body.in_situ.resize(mesh.elements.size());
  for (const ElementIndex element : changed_elements(change))
    body.in_situ[element] = in_situ_element(mesh, settings, element);

  const std::vector<NodeIndex> nodes = changed_nodes(change);
  std::erase_if(body.prescribed, [&nodes](const PrescribedNode& prescribed) {
    return std::binary_search(nodes.begin(), nodes.end(), prescribed.node);
  });
  const NodeLoads loads(mesh, elements, settings);
  for (const NodeIndex node : nodes) set_node(loads, node, body);
  std::sort(body.prescribed.begin(), body.prescribed.end(),
            [](const PrescribedNode& a, const PrescribedNode& b) { return a.node < b.node; });
}

}  // namespace fissura::structure
