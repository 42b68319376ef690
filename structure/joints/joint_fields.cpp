// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/joints/joint_fields.hpp"

#include "structure/joints/face_pair.hpp"

namespace fissura::structure {

void add_joint_fields(const Mesh& mesh, const Joints& joints, const FractureNetwork& network,
                      Message& fields) {
  const std::size_t units = mesh.units.size();
  std::vector<double> position, normal, slip, opening, normal_traction, shear_traction, pressure;
  std::vector<std::byte> kind, wetted;
  std::vector<std::uint64_t> line;
  for (UnitIndex index = 0; index < units; ++index) {
    const ContactUnit& unit = mesh.units[index];
    const JointState& state = joints.state[index];
    const FacePair pair = face_pair(unit);
    const ContactTraction traction =
        contact_traction(joints.properties[index], state, joints.released[index] != 0);
    const Point& at = mesh.vertices[unit.vertex].position;
    position.insert(position.end(), at.begin(), at.end());
    normal.insert(normal.end(), {pair.normal.x, pair.normal.y});
    kind.push_back(static_cast<std::byte>(joints.properties[index].kind));
    line.push_back(unit.line);
    slip.push_back(state.sliding);
    opening.push_back(state.opening);
    normal_traction.push_back(traction.normal);
    shear_traction.push_back(traction.shear);
    pressure.push_back(state.pressure);
    wetted.push_back(static_cast<std::byte>(network.contains(unit.vertex)));
  }
  fields.add("joint_position", "m", position, units, 2);
  fields.add("joint_normal", "1", normal, units, 2);
  fields.add_bytes("joint_kind", kind);
  fields.add_ids("joint_line", line);
  fields.add("joint_slip", "m", slip);
  fields.add("joint_opening", "m", opening);
  fields.add("joint_normal_traction", "Pa", normal_traction);
  fields.add("joint_shear_traction", "Pa", shear_traction);
  fields.add("joint_pressure", "Pa", pressure);
  fields.add_bytes("joint_wetted", wetted);
}

}  // namespace fissura::structure
