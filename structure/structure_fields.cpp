// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/structure_fields.hpp"

#include "structure/dynamics/element_fields.hpp"
#include "structure/dynamics/energy.hpp"
#include "structure/joints/joint_fields.hpp"

namespace fissura::structure {

namespace {

void add_mesh(const Mesh& mesh, Message& fields) {
  std::vector<double> position;
  for (const Point& point : mesh.position) position.insert(position.end(), point.begin(), point.end());
  fields.add("position", "m", position, mesh.position.size(), 2);
  std::vector<std::uint64_t> elements;
  for (const auto& corners : mesh.elements) elements.insert(elements.end(), corners.begin(), corners.end());
  fields.add_ids("elements", elements, 3);
}

}  // namespace

Message structure_fields(const StructureModel& model, const Geometry& geometry, const StructureState& state,
                         MeshInReport mesh) {
  Message fields(MessageType::fields);
  fields.body["geometry"] = geometry.number;
  if (mesh == MeshInReport::included) add_mesh(geometry.mesh, fields);
  const std::size_t nodes = geometry.mesh.position.size();
  fields.add("displacement", "m", state.body.displacement, nodes, 2);
  fields.add("velocity", "m/s", state.body.velocity, nodes, 2);
  const std::vector<ElementDamage> failed = damage_records(geometry.tiles, state.body.damage);
  std::vector<double> xx, yy, xy, zz;
  for (const ElementStress& stress :
       effective_stress(geometry.mesh, geometry.body, model.moduli, state.body.displacement, failed)) {
    xx.push_back(stress.in_plane.xx);
    yy.push_back(stress.in_plane.yy);
    xy.push_back(stress.in_plane.xy);
    zz.push_back(stress.out_of_plane);
  }
  fields.add("effective_stress_xx", "Pa", xx);
  fields.add("effective_stress_yy", "Pa", yy);
  fields.add("effective_stress_xy", "Pa", xy);
  fields.add("effective_stress_zz", "Pa", zz);
  if (!geometry.mesh.units.empty()) add_joint_fields(geometry.mesh, state.joints, geometry.network, fields);
  if (model.run_case.bulk_failure.active) {
    fields.add("damage", "1", damage_field(geometry.mesh, failed));
    fields.add("plastic_strain", "1", plastic_strain_field(geometry.mesh, failed));
  }
  return fields;
}

double strain_energy_of_body(const StructureModel& model, const Geometry& geometry, const StructureState& state) {
  return model.run_case.domain.thickness * strain_energy(geometry.mesh, model.moduli, state.body.displacement);
}

}  // namespace fissura::structure
