// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/joints/joint_observation.hpp"

#include <algorithm>
#include <limits>

#include "common/errors.hpp"
#include "structure/joints/face_pair.hpp"
#include "structure/joints/network_topology.hpp"

namespace fissura::structure {

namespace {

double arm_aperture(const Joints& joints, UnitIndex unit) {
  if (unit == no_unit) return 0;
  return aperture(joints.properties[unit], joints.state[unit]);
}

}  // namespace

JointObservation observe_joints(const Mesh& mesh, const Joints& joints, const FractureNetwork& network) {
  JointObservation seen;
  for (const NetworkNode& node : network.nodes()) {
    double length = 0, volume = 0, volume_rate = 0, pressure = 0;
    double opening_pressure = std::numeric_limits<double>::infinity();
    bool closed = true, broken = true;
    for (const UnitIndex unit : mesh.vertices[vertex_of(node.id)].units) {
      const double l = mesh.units[unit].length;
      const JointState& state = joints.state[unit];
      length += l;
      volume += l * aperture(joints.properties[unit], state);
      volume_rate += l * state.opening_rate;
      pressure += l * state.pressure;
      opening_pressure =
          std::min(opening_pressure, holding_cohesion(joints.properties[unit], state) - state.held_normal);
      closed = closed && state.closed;
      broken = broken && joints.broken(unit);
    }
    seen.aperture.push_back(volume / length);
    seen.aperture_rate.push_back(volume_rate / length);
    seen.pressure_applied.push_back(pressure / length);
    seen.pressure_opening.push_back(std::max(opening_pressure, 0.0));
    seen.closed.push_back(closed ? 1 : 0);
    seen.broken.push_back(broken ? 1 : 0);
  }
  for (const NetworkSegment& segment : network.segments()) {
    const FractureEdge& edge = mesh.edges[segment.id];
    seen.arm_aperture_a.push_back(arm_aperture(joints, edge.unit_at(vertex_of(segment.node_a))));
    seen.arm_aperture_b.push_back(arm_aperture(joints, edge.unit_at(vertex_of(segment.node_b))));
  }
  return seen;
}

void set_ramps(const Mesh& mesh, const FractureNetwork& network, const std::vector<PressureRamp>& ramp,
               Joints& joints) {
  ENSURE(ramp.size() == network.nodes().size());
  for (std::size_t i = 0; i < ramp.size(); ++i)
    for (const UnitIndex unit : mesh.vertices[vertex_of(network.nodes()[i].id)].units)
      joints.ramp[unit] = ramp[i];
}

}  // namespace fissura::structure
