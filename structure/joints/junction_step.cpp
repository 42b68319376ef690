// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/joints/junction_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "structure/joints/face_movement.hpp"

namespace fissura::structure {

namespace {

constexpr int most_sweeps = 50;
constexpr double settled = 1e-6;  // change of an impulse in a sweep, of the greatest one
constexpr double unbounded = std::numeric_limits<double>::infinity();

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

double least_normal_velocity(const FacePair& pair, const JointState& state, double step) {
  return touching(state) ? pair.rise / (pair.flatness * step) : -gap(state) / step;
}

/// Contact, cohesion and friction within their bounds.
void sweep(const FacePair& pair, const JointProperties& properties, bool released, double step,
           JointState& state, FaceImpulses& impulses, Hold& hold, std::span<double> velocity) {
  const double area_step = pair.length * step;
  double least = -unbounded;
  if (released) least = touching(state) ? -holding_cohesion(properties, state) * area_step : 0;
  const bool free = push(pair, pair.normal, least_normal_velocity(pair, state, step), least, unbounded,
                         impulses.normal, impulses.change, velocity);
  state.closed = !released || (touching(state) && free);
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
void project(const FacePair& pair, const Hold& hold, double step, const JointState& state,
             FaceImpulses& impulses, std::span<double> velocity) {
  push(pair, pair.normal, least_normal_velocity(pair, state, step), hold.normal ? -unbounded : 0, unbounded,
       impulses.normal, impulses.change, velocity);
  if (hold.tangential)
    push(pair, pair.tangent, 0, -unbounded, unbounded, impulses.tangential, impulses.change, velocity);
}

/// For each unit the first one that it is joined to through shared nodes.
std::vector<std::size_t> first_joined(const std::vector<SharingUnit>& units) {
  std::vector<std::size_t> first(units.size());
  std::iota(first.begin(), first.end(), std::size_t{0});
  const auto root = [&first](std::size_t k) {
    while (first[k] != k) k = first[k];
    return k;
  };
  std::map<NodeIndex, std::size_t> user;
  for (std::size_t k = 0; k < units.size(); ++k)
    for (const NodeIndex node : {units[k].pair.minus, units[k].pair.plus}) {
      const auto [found, is_new] = user.emplace(node, k);
      if (is_new) continue;
      const auto [low, high] = std::minmax({root(found->second), root(k)});
      first[high] = low;
    }
  for (std::size_t k = 0; k < units.size(); ++k) first[k] = root(k);
  return first;
}

}  // namespace

JunctionStep::JunctionStep(std::vector<SharingUnit> units) {
  const std::vector<std::size_t> first = first_joined(units);
  std::vector<std::size_t> order(units.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return first[a] < first[b]; });
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    std::vector<std::uint32_t> nodes;
    for (end = begin; end < order.size() && first[order[end]] == first[order[begin]]; ++end) {
      units_.push_back(units[order[end]]);
      nodes.insert(nodes.end(), {units_.back().place.minus, units_.back().place.plus});
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    junctions_.push_back({{begin, end}, {nodes_.size(), nodes_.size() + nodes.size()}});
    nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
  }
  fluid_.resize(junctions_.size());
  before_.resize(nodes_.size());
  impulses_.resize(units_.size());
  hold_.resize(units_.size());
}

/// Sweeps over the units of a junction until their impulses settle.
template <class Visit>
void JunctionStep::settle(const Range& units, const Visit& visit) {
  for (std::size_t k = units.begin; k < units.end; ++k) impulses_[k] = {};
  for (int round = 0; round < most_sweeps; ++round) {
    double change = 0, greatest = 0;
    for (std::size_t k = units.begin; k < units.end; ++k) {
      FaceImpulses& impulses = impulses_[k];
      impulses.change = 0;
      visit(k);
      change = std::max(change, impulses.change);
      greatest = std::max({greatest, std::abs(impulses.normal), std::abs(impulses.tangential)});
    }
    if (change <= settled * greatest) return;
  }
}

// One pressure for all arms: that of their mean aperture, which is what the network knows of a node. By its own
// aperture an open arm would lose the pressure that a closed one gained.
double JunctionStep::pressure_of_mean_aperture(const Junction& junction, double tau,
                                               const Joints& joints) const {
  double volume = 0, length = 0;
  const PressureRamp* ramp = nullptr;
  for (std::size_t k = junction.units.begin; k < junction.units.end; ++k) {
    const UnitIndex unit = units_[k].unit;
    if (!joints.released[unit]) continue;
    const double trace = units_[k].pair.length / units_[k].pair.flatness;
    volume += trace * aperture(joints.properties[unit], joints.state[unit]);
    length += trace;
    ramp = &joints.ramp[unit];
  }
  return ramp == nullptr ? 0 : ramp->applied(tau, volume / length);
}

void JunctionStep::load(std::size_t index, const JointNodes& nodes, const JointStepControls& controls,
                        Joints& joints) {
  const Junction& junction = junctions_[index];
  fluid_[index] = {pressure_of_mean_aperture(junction, controls.tau, joints), 0, 0};
  for (std::size_t k = junction.nodes.begin; k < junction.nodes.end; ++k)
    set(load_, nodes_[k], at(nodes.force, nodes_[k]));
  for (std::size_t k = junction.units.begin; k < junction.units.end; ++k) {
    const auto& [unit, place, geometry] = units_[k];
    FacePair& pair = units_[k].pair;
    pair.pressure = pair.rise = pair.normal_stiffness = pair.tangential_stiffness = 0;
    set_masses(nodes.mass, controls.mass_scale, pair);
    if (!joints.released[unit]) continue;
    const JointProperties& properties = joints.properties[unit];
    const JointState& state = joints.state[unit];
    pair.pressure = fluid_[index].pressure;
    CohesiveTraction pull;
    if (touching(state))
      pair.rise = dilation_rise(properties, state, relative_velocity(pair, pair.tangent, nodes.velocity),
                                controls.step);
    else
      pull = pull_by_cohesion(properties, state, pair);
    fluid_[index].length += pair.length / pair.flatness;
    if (pair.pressure > 0) fluid_[index].stiffness = joints.ramp[unit].stiffness;
    const Vector on_plus =
        pair.length * ((pair.pressure - pull.normal) * pair.normal - pull.tangential * pair.tangent);
    set(load_, place.plus, at(load_, place.plus) + on_plus);
    set(load_, place.minus, at(load_, place.minus) - on_plus);
  }
}

// The stiffness of the fluid couples the arms: only what they open together changes its pressure.
void JunctionStep::resist_fluid(std::size_t index, const JointNodes& nodes, const JointStepControls& controls,
                                const Joints& joints) const {
  const Junction& junction = junctions_[index];
  const Fluid& fluid = fluid_[index];
  if (fluid.stiffness == 0) return;
  const auto begin = nodes_.begin() + static_cast<std::ptrdiff_t>(junction.nodes.begin);
  const auto end = nodes_.begin() + static_cast<std::ptrdiff_t>(junction.nodes.end);
  const auto number = [&](std::uint32_t place) {
    return static_cast<std::size_t>(std::lower_bound(begin, end, place) - begin);
  };
  std::vector<Vector> gradient(junction.nodes.end - junction.nodes.begin);
  for (std::size_t k = junction.units.begin; k < junction.units.end; ++k) {
    const auto& [unit, place, pair] = units_[k];
    if (!joints.released[unit] || touching(joints.state[unit])) continue;
    const Vector face = pair.length * pair.normal;
    gradient[number(place.plus)] = gradient[number(place.plus)] + face;
    gradient[number(place.minus)] = gradient[number(place.minus)] - face;
  }
  const auto node_at = [&](std::size_t k) { return nodes.index[*(begin + static_cast<std::ptrdiff_t>(k))]; };
  const auto mass_at = [&](std::size_t k) { return controls.mass_scale * nodes.mass[node_at(k)]; };
  double rate = 0, response = 0;
  for (std::size_t k = 0; k < gradient.size(); ++k) {
    rate += dot(gradient[k], at(nodes.velocity, node_at(k)));
    response += dot(gradient[k], gradient[k]) / mass_at(k);
  }
  const double factor = fluid.stiffness * controls.step * controls.step / fluid.length;
  const double push_back = factor * rate / (1 + factor * response);
  for (std::size_t k = 0; k < gradient.size(); ++k)
    set(nodes.velocity, node_at(k),
        at(nodes.velocity, node_at(k)) - (push_back / mass_at(k)) * gradient[k]);
}

// Contact is solved twice: without damping, for the out-of-balance force that the damping needs (a single
// node's force would count the contact force as well), and once more after it, so that the damping leaves no
// overlap; the tractions are those of the first.
void JunctionStep::advance(std::size_t index, const JointNodes& nodes, const JointStepControls& controls,
                           Joints& joints) {
  const Junction& junction = junctions_[index];
  const double step = controls.step;
  load(index, nodes, controls, joints);
  const auto scaled_mass = [&](NodeIndex node) { return controls.mass_scale * nodes.mass[node]; };
  for (std::size_t k = junction.nodes.begin; k < junction.nodes.end; ++k) {
    const NodeIndex node = nodes.index[nodes_[k]];
    before_[k] = at(nodes.velocity, node);
    set(nodes.velocity, node, before_[k] + (step / scaled_mass(node)) * at(load_, nodes_[k]));
  }
  settle(junction.units, [&](std::size_t k) {
    const UnitIndex unit = units_[k].unit;
    sweep(units_[k].pair, joints.properties[unit], joints.released[unit] != 0, step, joints.state[unit],
          impulses_[k], hold_[k], nodes.velocity);
  });
  for (std::size_t k = junction.nodes.begin; k < junction.nodes.end; ++k) {
    const NodeIndex node = nodes.index[nodes_[k]];
    const double mass = scaled_mass(node);
    const Vector out_of_balance = (mass / step) * (at(nodes.velocity, node) - before_[k]);
    set(nodes.velocity, node,
        before_[k] + (step / mass) * damped(out_of_balance, before_[k], controls.damping));
  }
  for (std::size_t k = junction.units.begin; k < junction.units.end; ++k)
    if (!touching(joints.state[units_[k].unit])) resist_implicitly(units_[k].pair, step, nodes.velocity);
  resist_fluid(index, nodes, controls, joints);
  settle(junction.units, [&](std::size_t k) {
    project(units_[k].pair, hold_[k], step, joints.state[units_[k].unit], impulses_[k], nodes.velocity);
  });

  for (std::size_t k = junction.nodes.begin; k < junction.nodes.end; ++k) {
    const NodeIndex node = nodes.index[nodes_[k]];
    set(nodes.displacement, node, at(nodes.displacement, node) + step * at(nodes.velocity, node));
  }
  for (std::size_t k = junction.units.begin; k < junction.units.end; ++k) {
    const UnitIndex unit = units_[k].unit;
    FacePair& pair = units_[k].pair;
    if (!joints.released[unit]) continue;
    JointState& state = joints.state[unit];
    const FacePlace before = place_of(state);
    pair.stuck = hold_[k].tangential;
    state.dilation += pair.rise;
    observe(pair, joints.ramp[unit], controls.tau, joints.properties[unit], nodes.displacement,
            nodes.velocity, state);
    if (!joints.movement.empty())
      note_failure(pair, joints.properties[unit], before, state, controls.tau, step, joints.movement[unit]);
  }
  const double pressure = pressure_of_mean_aperture(junction, controls.tau, joints);
  for (std::size_t k = junction.units.begin; k < junction.units.end; ++k)
    if (joints.released[units_[k].unit]) joints.state[units_[k].unit].pressure = pressure;
}

}  // namespace fissura::structure
