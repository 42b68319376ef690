// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/joints/joint_step.hpp"

#include <algorithm>
#include <cmath>

#include "structure/joints/face_movement.hpp"

namespace fissura::structure {

namespace {

constexpr std::size_t units_ahead = 6;     // for which the memory is asked early
constexpr std::size_t least_units = 1000;  // below it a second thread costs more than it saves

/// Velocity of sliding after the step of two touching faces under friction [m/s].
double sliding_velocity(const FacePair& pair, double held_force, double velocity, double greatest_force,
                        double step) {
  const double to_stick = held_force + pair.reduced_mass() * velocity / step;
  if (std::abs(to_stick) <= greatest_force) return 0;
  return velocity + step / pair.reduced_mass() * (held_force - std::copysign(greatest_force, to_stick));
}

/// Mean pressure over the step between touching faces that takes away the velocity at which they meet [Pa].
double impact_traction(const FacePair& pair, double step, std::span<const double> velocity) {
  const double approach = -relative_velocity(pair, pair.normal, velocity);
  return std::max(approach, 0.0) * pair.reduced_mass() / (step * pair.length);
}

/// Velocities after the step of faces that touch.
void move_together(const FacePair& pair, Vector force, const JointStepControls& controls,
                   std::span<double> velocity) {
  const double total_mass = pair.mass_minus + pair.mass_plus;
  const Vector together = (1 / total_mass) * (pair.mass_minus * at(velocity, pair.minus) +
                                              pair.mass_plus * at(velocity, pair.plus));
  const Vector common = together + (controls.step / total_mass) * damped(force, together, controls.damping);
  set(velocity, pair.minus, common);
  set(velocity, pair.plus, common);
}

/// And of faces that are apart. @param on_plus  fluid pressure and cohesion [N/m]
void move_apart(const FacePair& pair, Vector force_minus, Vector force_plus, Vector on_plus,
                const JointStepControls& controls, std::span<double> velocity) {
  const Vector minus = at(velocity, pair.minus), plus = at(velocity, pair.plus);
  set(velocity, pair.minus,
      minus + (controls.step / pair.mass_minus) * damped(force_minus - on_plus, minus, controls.damping));
  set(velocity, pair.plus,
      plus + (controls.step / pair.mass_plus) * damped(force_plus + on_plus, plus, controls.damping));
}

[[gnu::always_inline]] inline void fetch(const double* values, std::size_t node) {
  __builtin_prefetch(values + 2 * node);
}

}  // namespace

JointStep::JointStep(const Mesh& mesh, std::span<const NodeIndex> joint_nodes, int threads)
    : threads_(threads) {
  std::vector<std::uint32_t> place_of(mesh.position.size(), 0), uses(mesh.position.size(), 0);
  for (std::uint32_t k = 0; k < joint_nodes.size(); ++k) place_of[joint_nodes[k]] = k;
  for (const ContactUnit& unit : mesh.units) {
    ++uses[unit.minus];
    ++uses[unit.plus];
  }
  std::vector<SharingUnit> sharing;
  for (UnitIndex k = 0; k < mesh.units.size(); ++k) {
    const ContactUnit& unit = mesh.units[k];
    const NodePlaces place{place_of[unit.minus], place_of[unit.plus]};
    const bool alone = uses[unit.minus] == 1 && uses[unit.plus] == 1;
    if (alone)
      ordinary_.push_back({k, place, face_pair(unit)});
    else
      sharing.push_back({k, place, face_pair(unit)});
  }
  junctions_ = JunctionStep(std::move(sharing));
}

inline void JointStep::fetch(const Ordinary& entry, const JointNodes& nodes) {
  structure::fetch(nodes.force.data(), entry.place.minus);
  structure::fetch(nodes.force.data(), entry.place.plus);
  for (const NodeIndex node : {entry.pair.minus, entry.pair.plus}) {
    __builtin_prefetch(nodes.mass.data() + node);
    structure::fetch(nodes.displacement.data(), node);
    structure::fetch(nodes.velocity.data(), node);
  }
}

void JointStep::advance(const JointNodes& nodes, const JointStepControls& controls, Joints& joints) {
  const bool parallel = threads_ > 1 && ordinary_.size() >= least_units;
  junctions_.prepare(nodes.index.size());
#pragma omp parallel num_threads(threads_) if (parallel)
  {
#pragma omp for schedule(static) nowait
    for (std::size_t k = 0; k < ordinary_.size(); ++k) {
      if (k + units_ahead < ordinary_.size()) fetch(ordinary_[k + units_ahead], nodes);
      advance_ordinary(ordinary_[k], nodes, controls, joints);
    }
#pragma omp for schedule(dynamic, 16)
    for (std::size_t k = 0; k < junctions_.size(); ++k) junctions_.advance(k, nodes, controls, joints);
  }
}

void JointStep::advance_ordinary(const Ordinary& entry, const JointNodes& nodes,
                                 const JointStepControls& controls, Joints& joints) {
  const UnitIndex unit = entry.unit;
  const JointProperties& properties = joints.properties[unit];
  const bool released = joints.released[unit] != 0;
  JointState& state = joints.state[unit];
  FacePair pair = entry.pair;
  set_masses(nodes.mass, controls.mass_scale, pair);
  const Vector force_minus = at(nodes.force, entry.place.minus),
               force_plus = at(nodes.force, entry.place.plus);
  const double total_mass = pair.mass_minus + pair.mass_plus, step = controls.step;
  const Vector held =
      (1 / (total_mass * pair.length)) * (pair.mass_minus * force_plus - pair.mass_plus * force_minus);
  state.held_normal = dot(held, pair.normal);
  state.held_tangential = dot(held, pair.tangent);
  if (released) load_by_fluid(joints.ramp[unit], controls.tau, properties, state, pair);
  state.closed = !released || (touching(state) &&
                               pair.pressure <= holding_cohesion(properties, state) - state.held_normal);

  if (state.closed) {
    const double before = relative_velocity(pair, pair.tangent, nodes.velocity);
    const double impact = impact_traction(pair, step, nodes.velocity);
    move_together(pair, force_minus + force_plus, controls, nodes.velocity);
    if (released) {
      const double greatest =
          greatest_shear_traction(properties, state, impact - (state.held_normal + pair.pressure));
      const double sliding =
          sliding_velocity(pair, state.held_tangential * pair.length, before, greatest * pair.length, step);
      pair.stuck = sliding == 0;
      if (!pair.stuck) change_relative_velocity(pair, pair.tangent, sliding, nodes.velocity);
      pair.rise = dilation_rise(properties, state, before, step);
      if (pair.rise > 0)
        change_relative_velocity(pair, pair.normal, pair.rise / (pair.flatness * step), nodes.velocity);
      state.dilation += pair.rise;
    }
  } else {
    const CohesiveTraction pull = pull_by_cohesion(properties, state, pair);
    const Vector on_plus =
        pair.length * ((pair.pressure - pull.normal) * pair.normal - pull.tangential * pair.tangent);
    move_apart(pair, force_minus, force_plus, on_plus, controls, nodes.velocity);
    resist_implicitly(pair, step, nodes.velocity);
    const double impulse = forbid_overlap(pair, gap(state), step, nodes.velocity);
    rub(pair, properties.friction_coefficient * impulse, nodes.velocity);
  }
  for (const NodeIndex node : {pair.minus, pair.plus})
    set(nodes.displacement, node, at(nodes.displacement, node) + step * at(nodes.velocity, node));
  if (!released) return;
  const FacePlace before = place_of(state);
  observe(pair, joints.ramp[unit], controls.tau, properties, nodes.displacement, nodes.velocity, state);
  if (!joints.movement.empty())
    note_failure(pair, properties, before, state, controls.tau, step, joints.movement[unit]);
}

}  // namespace fissura::structure
