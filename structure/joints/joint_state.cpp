// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/joints/joint_state.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::structure {

JointProperties joint_properties(const Mesh& mesh, UnitIndex index, const Rock& rock) {
  const ContactUnit& unit = mesh.units[index];
  const FractureLine& line = mesh.lines[unit.line];
  JointProperties properties;
  properties.kind = line.kind;
  properties.friction_coefficient = line.friction_coefficient;
  properties.friction_cohesion = line.cohesion;
  properties.residual_aperture = line.residual_aperture;
  properties.dilation = std::tan(line.dilation_angle);
  properties.dilation_slip = line.dilation_slip;
  if (line.kind != FractureKind::open && line.tensile_strength > 0)
    properties.cohesive = {
        tip_strength(line.tensile_strength, line.fracture_energy, rock.plane_strain_modulus(), unit.length),
        line.fracture_energy};
  return properties;
}

double cohesive_work(const Mesh& mesh, const Joints& joints) {
  double work = 0;
  for (UnitIndex unit = 0; unit < mesh.units.size(); ++unit)
    work += std::hypot(mesh.units[unit].face[0], mesh.units[unit].face[1]) * joints.properties[unit].cohesive.spent_energy(joints.state[unit].greatest_separation);
  return work;
}

VertexIndex nearest_split_vertex(const Mesh& mesh, const Point& position) {
  VertexIndex nearest = 0;
  double smallest = INFINITY;
  for (VertexIndex v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v].units.empty()) continue;
    const Point& at = mesh.vertices[v].position;
    const double distance = std::hypot(at[0] - position[0], at[1] - position[1]);
    if (distance < smallest) {
      smallest = distance;
      nearest = v;
    }
  }
  return nearest;
}

bool has_natural_fractures(const Mesh& mesh) {
  return std::any_of(mesh.lines.begin(), mesh.lines.end(),
                     [](const FractureLine& line) { return line.kind == FractureKind::natural; });
}

Joints make_joints(const Mesh& mesh, const Case& run_case) {
  Joints joints;
  joints.state.resize(mesh.units.size());
  joints.ramp.resize(mesh.units.size());
  for (UnitIndex index = 0; index < mesh.units.size(); ++index) {
    const ContactUnit& unit = mesh.units[index];
    const FractureLine& line = mesh.lines[unit.line];
    joints.properties.push_back(joint_properties(mesh, index, run_case.rock));
    joints.released.push_back(line.kind != FractureKind::intact);
    if (line.kind == FractureKind::natural) {
      const double p = pore_pressure(run_case.in_situ, mesh.vertices[unit.vertex].position);
      joints.ramp[index] = {p, p, 0, 0, 0};
      joints.state[index].pressure = p;
    }
  }
  for (const Perforation& perforation : run_case.injection.perforations)
    for (const UnitIndex unit : mesh.vertices[nearest_split_vertex(mesh, perforation.position)].units)
      joints.properties[unit].stored_aperture = perforation.aperture;
  return joints;
}

}  // namespace fissura::structure
