// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/joints/junction_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "structure/joints/face_pair.hpp"

namespace fissura::structure {

namespace {

constexpr int most_sweeps = 50;
constexpr double settled = 1e-6;  // change of an impulse in a sweep, of the greatest one
constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Impulses on the faces of a unit [N s/m] and the bounds they keep to.
struct Impulses {
  double normal = 0, tangential = 0;
  double change = 0;  ///< greatest one in the last sweep
};

/// Changes an impulse by what takes the relative velocity to `wanted`, within bounds. @returns whether the
/// bounds allowed it
bool push(const FacePair& pair, Vector direction, double wanted, double least, double most, double& impulse,
          double& change, std::span<double> velocity) {
  const double mass = pair.reduced_mass();
  const double needed = impulse + mass * (wanted - relative_velocity(pair, direction, velocity));
  const double given = std::clamp(needed, least, most);
  change_relative_velocity(pair, direction, (given - impulse) / mass, velocity);
  change = std::max(change, std::abs(given - impulse));
  impulse = given;
  return given == needed;
}

/// What holds the faces of a unit together.
struct Hold {
  bool normal = false, tangential = false;
};

double least_normal_velocity(const JointState& state, double step) {
  return state.opening <= contact_tolerance ? 0 : -state.opening / step;
}

/// Contact, cohesion and friction within their bounds.
void sweep(const FacePair& pair, const JointProperties& properties, bool released, double step,
           JointState& state, Impulses& impulses, Hold& hold, std::span<double> velocity) {
  const bool touching = state.opening <= contact_tolerance;
  const double area_step = pair.length * step;
  double least = -unbounded;
  if (released) least = touching ? -holding_cohesion(properties, state) * area_step : 0;
  const bool free = push(pair, pair.normal, least_normal_velocity(state, step), least, unbounded,
                         impulses.normal, impulses.change, velocity);
  state.closed = !released || (touching && free);
  // The fluid pressure is among the loads; what the rock itself transmits is the rest.
  state.held_normal = -(impulses.normal / area_step + pair.pressure);
  const double greatest =
      !released       ? unbounded
      : !state.closed ? 0
                      : greatest_shear_traction(properties, state, impulses.normal / area_step) * area_step;
  hold.normal = state.closed;
  hold.tangential =
      push(pair, pair.tangent, 0, -greatest, greatest, impulses.tangential, impulses.change, velocity) &&
      state.closed;
  state.held_tangential = -impulses.tangential / area_step;
}

/// Keeps together what is held, and lets nothing overlap: no new traction.
void project(const FacePair& pair, const Hold& hold, double step, const JointState& state, Impulses& impulses,
             std::span<double> velocity) {
  push(pair, pair.normal, least_normal_velocity(state, step), hold.normal ? -unbounded : 0, unbounded,
       impulses.normal, impulses.change, velocity);
  if (hold.tangential)
    push(pair, pair.tangent, 0, -unbounded, unbounded, impulses.tangential, impulses.change, velocity);
}

/// Sweeps over all units until their impulses settle.
template <class Visit>
void settle(std::size_t units, const Visit& visit) {
  std::vector<Impulses> impulses(units);
  for (int round = 0; round < most_sweeps; ++round) {
    double change = 0, greatest = 0;
    for (std::size_t k = 0; k < units; ++k) {
      impulses[k].change = 0;
      visit(k, impulses[k]);
      change = std::max(change, impulses[k].change);
      greatest = std::max({greatest, std::abs(impulses[k].normal), std::abs(impulses[k].tangential)});
    }
    if (change <= settled * greatest) return;
  }
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

// Contact is solved twice: without damping, for the out-of-balance force that the damping needs (a single
// node's force would count the contact force as well), and once more after it, so that the damping leaves no
// overlap; the tractions are those of the first.
void JunctionStep::advance_velocities(const Mesh& mesh, const JointNodes& nodes,
                                      const JointStepControls& controls, Joints& joints) {
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
    set(nodes.velocity, node,
        before.back() + (step / (controls.mass_scale * nodes.mass[node])) * at(load_, place));
  }
  std::vector<Hold> hold(pairs.size());
  settle(pairs.size(), [&](std::size_t k, Impulses& impulses) {
    sweep(pairs[k], joints.properties[units_[k]], joints.released[units_[k]] != 0, step,
          joints.state[units_[k]], impulses, hold[k], nodes.velocity);
  });
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const NodeIndex node = nodes.index[nodes_[k]];
    const double mass = controls.mass_scale * nodes.mass[node];
    const Vector out_of_balance = (mass / step) * (at(nodes.velocity, node) - before[k]);
    set(nodes.velocity, node,
        before[k] + (step / mass) * damped(out_of_balance, before[k], controls.damping));
  }
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (joints.state[units_[k]].opening > contact_tolerance)
      resist_implicitly(pairs[k], step, nodes.velocity);
  settle(pairs.size(), [&](std::size_t k, Impulses& impulses) {
    project(pairs[k], hold[k], step, joints.state[units_[k]], impulses, nodes.velocity);
  });
}

}  // namespace fissura::structure
