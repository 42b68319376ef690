// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/joints/face_pair.hpp"

#include <algorithm>

namespace fissura::structure {

namespace {

constexpr double fastest_rise = 1.1;  // of what the present sliding asks for: makes up for steps before a stop

double damped(double force, double velocity, double lambda) {
  if (velocity == 0) return force;
  return force - lambda * std::abs(force) * (velocity > 0 ? 1.0 : -1.0);
}

void resist(const FacePair& pair, Vector direction, double stiffness, double step,
            std::span<double> velocity) {
  if (stiffness == 0) return;
  const double v = relative_velocity(pair, direction, velocity);
  const double ratio = stiffness * pair.length * step * step / pair.reduced_mass();
  change_relative_velocity(pair, direction, v / (1 + ratio) - v, velocity);
}

}  // namespace

Vector damped(Vector force, Vector velocity, double lambda) {
  return {damped(force.x, velocity.x, lambda), damped(force.y, velocity.y, lambda)};
}

FacePair face_pair(const ContactUnit& unit) {
  FacePair pair;
  pair.minus = unit.minus;
  pair.plus = unit.plus;
  pair.length = std::hypot(unit.face[0], unit.face[1]);
  pair.flatness = pair.length / unit.length;
  pair.normal = (1 / pair.length) * Vector{unit.face[0], unit.face[1]};
  pair.tangent = {pair.normal.y, -pair.normal.x};
  return pair;
}

FacePair face_pair(const ContactUnit& unit, std::span<const double> mass, double mass_scale) {
  FacePair pair = face_pair(unit);
  set_masses(mass, mass_scale, pair);
  return pair;
}

void set_masses(std::span<const double> mass, double mass_scale, FacePair& pair) {
  pair.mass_minus = mass_scale * mass[pair.minus];
  pair.mass_plus = mass_scale * mass[pair.plus];
}

double dilation_rise(const JointProperties& properties, const JointState& state, double sliding_velocity,
                     double step) {
  if (properties.dilation == 0) return 0;
  const double due = properties.dilation * std::min(state.slip, properties.dilation_slip) - state.dilation;
  return std::clamp(due, 0.0, fastest_rise * properties.dilation * std::abs(sliding_velocity) * step);
}

double aperture(const JointProperties& properties, const JointState& state) {
  double residual = properties.residual_aperture;
  if (residual > 0 && properties.cohesive.strength > 0)
    residual *= 1 - properties.cohesive.envelope(state.greatest_separation) / properties.cohesive.strength;
  return std::max(state.opening, 0.0) + properties.stored_aperture + residual;
}

void load_by_fluid(const PressureRamp& ramp, double tau, const JointProperties& properties,
                   const JointState& state, FacePair& pair) {
  pair.pressure = ramp.applied(tau, aperture(properties, state));
  if (pair.pressure > 0) pair.normal_stiffness += ramp.stiffness;
}

CohesiveTraction pull_by_cohesion(const JointProperties& properties, const JointState& state,
                                  FacePair& pair) {
  const double q = state.greatest_separation, opening = std::max(state.opening, 0.0);
  const CohesiveTraction pull = cohesion(properties.cohesive, opening, state.sliding, q);
  const double envelope = properties.cohesive.envelope(q);
  if (q > rigid_separation && opening < q) pair.normal_stiffness += envelope / q;
  pair.tangential_stiffness = envelope / std::max(q, tangential_separation);
  return pull;
}

double holding_cohesion(const JointProperties& properties, const JointState& state) {
  return cohesion(properties.cohesive, std::max(state.opening, 0.0), 0, state.greatest_separation).normal;
}

double greatest_shear_traction(const JointProperties& properties, const JointState& state,
                               double contact_pressure) {
  return properties.friction_cohesion + properties.cohesive.envelope(state.greatest_separation) +
         properties.friction_coefficient * std::max(contact_pressure, 0.0);
}

ContactTraction contact_traction(const JointProperties& properties, const JointState& state, bool released) {
  if (!state.closed) return {};
  const double normal = state.held_normal + state.pressure;
  if (!released) return {normal, state.held_tangential};
  const double greatest = greatest_shear_traction(properties, state, -normal);
  return {normal, std::clamp(state.held_tangential, -greatest, greatest)};
}

double relative_velocity(const FacePair& pair, Vector direction, std::span<const double> velocity) {
  return dot(at(velocity, pair.plus) - at(velocity, pair.minus), direction);
}

void change_relative_velocity(const FacePair& pair, Vector direction, double change,
                              std::span<double> velocity) {
  const double impulse = pair.reduced_mass() * change;
  set(velocity, pair.plus, at(velocity, pair.plus) + (impulse / pair.mass_plus) * direction);
  set(velocity, pair.minus, at(velocity, pair.minus) - (impulse / pair.mass_minus) * direction);
}

void resist_implicitly(const FacePair& pair, double step, std::span<double> velocity) {
  resist(pair, pair.normal, pair.normal_stiffness, step, velocity);
  resist(pair, pair.tangent, pair.tangential_stiffness, step, velocity);
}

double forbid_overlap(const FacePair& pair, double gap, double step, std::span<double> velocity) {
  const double v = relative_velocity(pair, pair.normal, velocity);
  const double least = -std::max(gap, 0.0) / step;
  if (v >= least) return 0;
  change_relative_velocity(pair, pair.normal, least - v, velocity);
  return pair.reduced_mass() * (least - v);
}

void rub(const FacePair& pair, double greatest, std::span<double> velocity) {
  if (greatest == 0) return;
  const double v = relative_velocity(pair, pair.tangent, velocity), change = greatest / pair.reduced_mass();
  change_relative_velocity(pair, pair.tangent, -std::clamp(v, -change, change), velocity);
}

void observe(const FacePair& pair, const PressureRamp& ramp, double tau, const JointProperties& properties,
             std::span<const double> displacement, std::span<const double> velocity, JointState& state) {
  const Vector jump = at(displacement, pair.plus) - at(displacement, pair.minus);
  const double sliding = dot(jump, pair.tangent) - state.sliding_at_rest;
  if (state.closed) state.slip += std::abs(sliding - state.sliding);
  state.opening = pair.flatness * dot(jump, pair.normal);
  state.sliding = sliding;
  state.opening_rate = pair.flatness * relative_velocity(pair, pair.normal, velocity);
  const double opening = std::max(state.opening, 0.0);
  state.greatest_separation =
      std::max(state.greatest_separation, std::sqrt(opening * opening + sliding * sliding));
  state.pressure = ramp.applied(tau, aperture(properties, state));
}

}  // namespace fissura::structure
