// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/joints/junction_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "structure/joints/face_pair.hpp"

namespace fissura::structure {

namespace {

constexpr int sweeps = 8;
constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Impulses of one sweep sequence, per unit [N s/m].
struct Impulses {
  std::vector<double> normal, tangential;
};

void sweep(const FacePair& pair, const JointProperties& properties, bool released, double step, JointState& state,
           double& normal_impulse, double& tangential_impulse, std::span<double> velocity) {
  const bool touching = state.opening <= contact_tolerance;
  const double mass = pair.reduced_mass(), area_step = pair.length * step;

  const double least_velocity = touching ? 0 : -state.opening / step;
  double least_impulse = -unbounded;
  if (released) least_impulse = touching ? -holding_cohesion(properties, state) * area_step : 0;
  const double wanted = normal_impulse + mass * (least_velocity - relative_velocity(pair, pair.normal, velocity));
  const double impulse = std::max(wanted, least_impulse);
  change_relative_velocity(pair, pair.normal, (impulse - normal_impulse) / mass, velocity);
  normal_impulse = impulse;
  state.closed = !released || (touching && impulse == wanted);
  // The fluid pressure is among the loads; what the rock itself transmits is the rest.
  state.held_normal = -(impulse / area_step + pair.pressure);

  if (!state.closed) return;
  const double greatest =
      released ? greatest_shear_traction(properties, state, impulse / area_step) * area_step : unbounded;
  const double shear =
      std::clamp(tangential_impulse - mass * relative_velocity(pair, pair.tangent, velocity), -greatest, greatest);
  change_relative_velocity(pair, pair.tangent, (shear - tangential_impulse) / mass, velocity);
  tangential_impulse = shear;
  state.held_tangential = -shear / area_step;
}

}  // namespace

JunctionStep::JunctionStep(std::vector<UnitIndex> units, std::span<const NodePlaces> places)
    : units_(std::move(units)) {
  for (const UnitIndex unit : units_) {
    place_.push_back(places[unit]);
    nodes_.push_back(places[unit].minus);
    nodes_.push_back(places[unit].plus);
  }
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
}

// Contact is solved twice: without damping, for the out-of-balance force that the damping needs (a single node's force would count the
// contact force as well), and once more after it, so that the damping leaves no overlap.
void JunctionStep::advance_velocities(const Mesh& mesh, const JointNodes& nodes, const JointStepControls& controls,
                                      Joints& joints) {
  if (units_.empty()) return;
  const double step = controls.step;
  load_.assign(nodes.force.begin(), nodes.force.end());
  std::vector<FacePair> pairs;
  for (std::size_t k = 0; k < units_.size(); ++k) {
    const UnitIndex unit = units_[k];
    FacePair& pair = pairs.emplace_back(face_pair(mesh.units[unit], nodes.mass, controls.mass_scale));
    if (!joints.released[unit]) continue;
    const JointState& state = joints.state[unit];
    load_by_fluid(joints.ramp[unit], controls.tau, joints.properties[unit], state, pair);
    CohesiveTraction pull;
    if (state.opening > contact_tolerance) pull = pull_by_cohesion(joints.properties[unit], state, pair);
    const Vector on_plus =
        pair.length * ((pair.pressure - pull.normal) * pair.normal - pull.tangential * pair.tangent);
    set(load_, place_[k].plus, at(load_, place_[k].plus) + on_plus);
    set(load_, place_[k].minus, at(load_, place_[k].minus) - on_plus);
  }

  std::vector<Vector> before;
  for (const std::uint32_t place : nodes_) {
    const NodeIndex node = nodes.index[place];
    before.push_back(at(nodes.velocity, node));
    set(nodes.velocity, node, before.back() + (step / (controls.mass_scale * nodes.mass[node])) * at(load_, place));
  }
  const auto sweep_all = [&] {
    Impulses impulses{std::vector<double>(pairs.size(), 0), std::vector<double>(pairs.size(), 0)};
    for (int round = 0; round < sweeps; ++round)
      for (std::size_t k = 0; k < pairs.size(); ++k)
        sweep(pairs[k], joints.properties[units_[k]], joints.released[units_[k]] != 0, step, joints.state[units_[k]],
              impulses.normal[k], impulses.tangential[k], nodes.velocity);
  };
  sweep_all();
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const NodeIndex node = nodes.index[nodes_[k]];
    const double mass = controls.mass_scale * nodes.mass[node];
    const Vector out_of_balance = (mass / step) * (at(nodes.velocity, node) - before[k]);
    set(nodes.velocity, node, before[k] + (step / mass) * damped(out_of_balance, before[k], controls.damping));
  }
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (joints.state[units_[k]].opening > contact_tolerance) resist_implicitly(pairs[k], step, nodes.velocity);
  std::vector<JointState> after_contact;
  for (const UnitIndex unit : units_) after_contact.push_back(joints.state[unit]);
  sweep_all();
  // The second solution only projects; the tractions are those of the first.
  for (std::size_t k = 0; k < units_.size(); ++k) {
    joints.state[units_[k]].held_normal = after_contact[k].held_normal;
    joints.state[units_[k]].held_tangential = after_contact[k].held_tangential;
    joints.state[units_[k]].closed = after_contact[k].closed;
  }
}

}  // namespace fissura::structure
