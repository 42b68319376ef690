// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/structure_state.hpp"

#include "structure/dynamics/stable_step.hpp"
#include "structure/mesh/build_mesh.hpp"

namespace fissura::structure {

Geometry build_geometry(const StructureModel& model) {
  Geometry geometry;
  geometry.mesh = build_mesh(model.run_case);
  geometry.node_elements = NodeElements(geometry.mesh);
  geometry.body = build_body(geometry.mesh, model.run_case);
  geometry.joint_nodes = joint_nodes(geometry.mesh);
  geometry.tiles = build_tiles(geometry.mesh, geometry.body, geometry.joint_nodes);
  geometry.frequency_bound = bound_frequencies(geometry.mesh, model.moduli, model.run_case.rock.density);
  geometry.frequency_squared = stiffest_element(geometry.mesh, geometry.frequency_bound).frequency_squared;
  return geometry;
}

void follow(const StructureModel& model, const MeshChange& change, Geometry& geometry) {
  const Mesh& mesh = geometry.mesh;
  geometry.node_elements.follow(mesh, change);
  update_body(mesh, geometry.node_elements, model.run_case, change, geometry.body);
  geometry.joint_nodes = joint_nodes(mesh);
  update_tiles(mesh, geometry.node_elements, geometry.body, geometry.joint_nodes, change, geometry.tiles);
  update_frequencies(mesh, geometry.node_elements, model.moduli, model.run_case.rock.density, change,
                     geometry.frequency_bound);
  geometry.frequency_squared = stiffest_element(mesh, geometry.frequency_bound).frequency_squared;
  ++geometry.number;
}

StructureState initial_state(const StructureModel& model, const Geometry& geometry) {
  State body = model.run_case.bulk_failure.active ? state_at_rest(geometry.body, geometry.tiles)
                                                  : state_at_rest(geometry.body);
  return {std::move(body), make_joints(geometry.mesh, model.run_case),
          MassScaling(model.run_case.dynamics, model.run_case.rock), 0, {},
          SourceObserver(model.run_case.seismicity)};
}

double stable_step(const StructureModel& model, const Geometry& geometry, const StructureState& state) {
  constexpr double no_spring = 0;
  const Dynamics& dynamics = model.run_case.dynamics;
  return stable_step(geometry.frequency_squared, no_spring,
                     {dynamics.safety_factor, state.mass_scaling.scale(), dynamics.damping});
}

ObservedRock observed_rock(const StructureModel& model, const Geometry& geometry,
                           const StructureState& state) {
  return {geometry.mesh,   geometry.body,   geometry.tiles,          model.moduli,
          model.run_case,  geometry.number, state.body.displacement, state.body.damage};
}

double connected_half_length(const FractureNetwork& network) {
  double length = 0;
  for (const NetworkNode& node : network.nodes()) length += node.lumped_length;
  return length / 2;
}

}  // namespace fissura::structure
