// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/initial_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "common/errors.hpp"
#include "structure/dynamics/triangle.hpp"
#include "structure/structure_run.hpp"

namespace fissura::structure {

namespace {

constexpr double damping_to_rest =
    0.7;  // friction is overshot by (1 - lambda) / (1 + lambda) of the way at most
constexpr int steps_of_first_check = 10;
constexpr double motion_of_the_resting = 1e-14;  // rounding of displacements, per step of the first check [m]

/// The joints while only natural fractures may move.
Joints natural_alone(const Joints& joints) {
  Joints held = joints;
  for (std::size_t unit = 0; unit < held.properties.size(); ++unit) {
    held.properties[unit].dilation = 0;
    if (held.properties[unit].kind != FractureKind::natural) held.released[unit] = 0;
  }
  return held;
}

double greatest_change(std::span<const double> before, std::span<const double> now) {
  double greatest = 0;
  for (std::size_t k = 0; k < before.size(); ++k) greatest = std::max(greatest, std::abs(now[k] - before[k]));
  return greatest;
}

UnitIndex fastest(const Geometry& geometry, const Joints& before, const Joints& now) {
  UnitIndex found = 0;
  double greatest = -1;
  for (UnitIndex unit = 0; unit < geometry.mesh.units.size(); ++unit) {
    const JointState &a = before.state[unit], &b = now.state[unit];
    const double moved = std::hypot(b.sliding - a.sliding, b.opening - a.opening);
    if (moved <= greatest || now.properties[unit].kind != FractureKind::natural) continue;
    greatest = moved;
    found = unit;
  }
  return found;
}

[[noreturn]] void refuse(const Geometry& geometry, const Joints& before, const Joints& now,
                         std::uint64_t steps) {
  const ContactUnit& unit = geometry.mesh.units[fastest(geometry, before, now)];
  const Point& at = geometry.mesh.vertices[unit.vertex].position;
  throw InputError(fmt::format(
      "natural fracture '{}' does not come to rest under the in-situ stress: it still moves at ({:.6g}, "
      "{:.6g}) m after {} steps; give it more friction or cohesion, or set dynamics.equilibrate = false",
      geometry.mesh.lines[unit.line].name, at[0], at[1], steps));
}

/// Slip counts from the present place; joints that may not move before time 0 are as they were.
void count_from_here(const Joints& before, Joints& joints) {
  for (std::size_t unit = 0; unit < joints.state.size(); ++unit) {
    if (before.properties[unit].kind != FractureKind::natural) {
      joints.state[unit] = before.state[unit];
      continue;
    }
    JointState& state = joints.state[unit];
    state.sliding_at_rest += state.sliding;
    state.sliding = 0;
    state.slip = 0;
    state.opening_rate = 0;
    if (!joints.broken(static_cast<UnitIndex>(unit)))
      state.greatest_separation = before.state[unit].greatest_separation;
  }
  joints.properties = before.properties;
  joints.released = before.released;
}

}  // namespace

Equilibration come_to_rest(const StructureModel& model, const Geometry& geometry, StructureState& state) {
  Equilibration rest;
  if (!has_natural_fractures(geometry.mesh)) return rest;
  StructureModel damped = model;
  damped.run_case.dynamics.damping = std::max(damped.run_case.dynamics.damping, damping_to_rest);
  StructureRun run(damped, geometry);
  const Joints before = state.joints;
  state.joints = natural_alone(before);
  const double step = stable_step(damped, geometry, state);
  // Times before 0: what the sides do begins at 0.
  std::vector<double> displacement = state.body.displacement;
  Joints joints = state.joints;
  const auto advance = [&](int steps) {
    try {
      rest.steps += run.advance(-2 * steps * step, -steps * step, state);
    } catch (const SolverError&) {  // faces that no longer face each other
      refuse(geometry, joints, state.joints, rest.steps);
    }
  };
  advance(steps_of_first_check);
  bool resting =
      greatest_change(displacement, state.body.displacement) <= steps_of_first_check * motion_of_the_resting;
  for (int check = 0; !resting; ++check) {
    if (check == most_checks) refuse(geometry, joints, state.joints, rest.steps);
    displacement = state.body.displacement;
    joints = state.joints;
    advance(steps_between_checks);
    resting = greatest_change(displacement, state.body.displacement) <= negligible_motion;
  }
  for (UnitIndex unit = 0; unit < geometry.mesh.units.size(); ++unit) {
    const double slip = std::abs(state.joints.state[unit].sliding);
    if (slip <= rest.greatest_slip || before.properties[unit].kind != FractureKind::natural) continue;
    rest.greatest_slip = slip;
    rest.fracture = geometry.mesh.lines[geometry.mesh.units[unit].line].name;
  }
  std::fill(state.body.velocity.begin(), state.body.velocity.end(), 0.0);
  count_from_here(before, state.joints);
  state.sources.begin_anew(state.joints);
  return rest;
}

void start_motion(const StructureModel& model, const Geometry& geometry, StructureState& state) {
  const Mesh& mesh = geometry.mesh;
  for (const InitialVelocity& part : model.run_case.initial_velocities) {
    const auto inside = [&](ElementIndex element) {
      const Point at = centroid(mesh, element);
      return at[0] > part.west && at[0] < part.east && at[1] > part.south && at[1] < part.north;
    };
    for (NodeIndex node = 0; node < mesh.position.size(); ++node) {
      const auto elements = geometry.node_elements.of(node);
      if (elements.empty() || !std::all_of(elements.begin(), elements.end(), inside)) continue;
      for (std::size_t axis = 0; axis < 2; ++axis)
        if (geometry.body.inverse_mass[node][axis] > 0)
          state.body.velocity[2 * std::size_t{node} + axis] = part.velocity[axis];
    }
  }
}

}  // namespace fissura::structure
