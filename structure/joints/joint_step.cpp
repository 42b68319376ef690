// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/joints/joint_step.hpp"

#include <algorithm>
#include <cmath>

#include "structure/joints/face_pair.hpp"

namespace fissura::structure {

namespace {

/// Velocity of sliding after the step of two touching faces under friction [m/s].
double sliding_velocity(const FacePair& pair, double held_force, double velocity, double greatest_force, double step) {
  const double to_stick = held_force + pair.reduced_mass() * velocity / step;
  if (std::abs(to_stick) <= greatest_force) return 0;
  return velocity + step / pair.reduced_mass() * (held_force - std::copysign(greatest_force, to_stick));
}

/// Opening, sliding and pressure at the end of the step.
void observe(const FacePair& pair, const JointNodes& nodes, const JointProperties& properties, const PressureRamp& ramp,
             double tau, JointState& state) {
  const Vector jump = at(nodes.displacement, pair.plus) - at(nodes.displacement, pair.minus);
  const double sliding = dot(jump, pair.tangent);
  if (state.closed) state.slip += std::abs(sliding - state.sliding);
  state.opening = pair.flatness * dot(jump, pair.normal);
  state.sliding = sliding;
  state.opening_rate = pair.flatness * relative_velocity(pair, pair.normal, nodes.velocity);
  state.greatest_separation = std::max(state.greatest_separation, std::hypot(std::max(state.opening, 0.0), sliding));
  state.pressure = ramp.applied(tau, aperture(properties, state));
}

std::vector<NodePlaces> places_of(const Mesh& mesh, std::span<const NodeIndex> joint_nodes) {
  std::vector<std::uint32_t> place_of(mesh.position.size(), 0);
  for (std::uint32_t k = 0; k < joint_nodes.size(); ++k) place_of[joint_nodes[k]] = k;
  std::vector<NodePlaces> places;
  for (const ContactUnit& unit : mesh.units) places.push_back({place_of[unit.minus], place_of[unit.plus]});
  return places;
}

}  // namespace

JointStep::JointStep(const Mesh& mesh, std::span<const NodeIndex> joint_nodes) : place_(places_of(mesh, joint_nodes)) {
  std::vector<std::uint32_t> uses(mesh.position.size(), 0);
  for (const ContactUnit& unit : mesh.units) {
    ++uses[unit.minus];
    ++uses[unit.plus];
  }
  std::vector<UnitIndex> sharing;
  for (UnitIndex k = 0; k < mesh.units.size(); ++k) {
    const bool alone = uses[mesh.units[k].minus] == 1 && uses[mesh.units[k].plus] == 1;
    (alone ? ordinary_ : sharing).push_back(k);
  }
  junctions_ = JunctionStep(std::move(sharing), place_);
}

void JointStep::advance(const Mesh& mesh, const JointNodes& nodes, const JointStepControls& controls, Joints& joints) {
  for (const UnitIndex unit : ordinary_) advance_ordinary(mesh, nodes, controls, unit, joints);
  junctions_.advance_velocities(mesh, nodes, controls, joints);
  for (const NodeIndex node : nodes.index)
    set(nodes.displacement, node, at(nodes.displacement, node) + controls.step * at(nodes.velocity, node));
  for (UnitIndex unit = 0; unit < mesh.units.size(); ++unit)
    if (joints.released[unit])
      observe(face_pair(mesh.units[unit], nodes.mass, controls.mass_scale), nodes, joints.properties[unit],
              joints.ramp[unit], controls.tau, joints.state[unit]);
}

void JointStep::advance_ordinary(const Mesh& mesh, const JointNodes& nodes, const JointStepControls& controls,
                                 UnitIndex unit, Joints& joints) const {
  const JointProperties& properties = joints.properties[unit];
  const bool released = joints.released[unit] != 0;
  JointState& state = joints.state[unit];
  FacePair pair = face_pair(mesh.units[unit], nodes.mass, controls.mass_scale);
  const Vector force_minus = at(nodes.force, place_[unit].minus), force_plus = at(nodes.force, place_[unit].plus);
  const double total_mass = pair.mass_minus + pair.mass_plus, step = controls.step;
  const Vector held =
      (1 / (total_mass * pair.length)) * (pair.mass_minus * force_plus - pair.mass_plus * force_minus);
  state.held_normal = dot(held, pair.normal);
  state.held_tangential = dot(held, pair.tangent);
  if (released) load_by_fluid(joints.ramp[unit], controls.tau, properties, state, pair);
  state.closed = !released || (state.opening <= contact_tolerance &&
                               pair.pressure <= holding_cohesion(properties, state) - state.held_normal);

  const Vector before_minus = at(nodes.velocity, pair.minus), before_plus = at(nodes.velocity, pair.plus);
  if (state.closed) {
    const Vector together = (1 / total_mass) * (pair.mass_minus * before_minus + pair.mass_plus * before_plus);
    const Vector common = together + (step / total_mass) * damped(force_minus + force_plus, together, controls.damping);
    set(nodes.velocity, pair.minus, common);
    set(nodes.velocity, pair.plus, common);
    if (!released) return;
    const double greatest = greatest_shear_traction(properties, state, -(state.held_normal + pair.pressure));
    const double sliding = sliding_velocity(pair, state.held_tangential * pair.length,
                                            dot(before_plus - before_minus, pair.tangent), greatest * pair.length, step);
    if (sliding != 0) change_relative_velocity(pair, pair.tangent, sliding, nodes.velocity);
    return;
  }
  const CohesiveTraction pull = pull_by_cohesion(properties, state, pair);
  const Vector on_plus = pair.length * ((pair.pressure - pull.normal) * pair.normal - pull.tangential * pair.tangent);
  set(nodes.velocity, pair.minus,
      before_minus + (step / pair.mass_minus) * damped(force_minus - on_plus, before_minus, controls.damping));
  set(nodes.velocity, pair.plus,
      before_plus + (step / pair.mass_plus) * damped(force_plus + on_plus, before_plus, controls.damping));
  resist_implicitly(pair, step, nodes.velocity);
  forbid_overlap(pair, state.opening, step, nodes.velocity);
}

}  // namespace fissura::structure
