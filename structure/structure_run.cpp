// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/structure_run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "common/errors.hpp"
#include "common/exchange/participant.hpp"
#include "structure/dynamics/energy.hpp"
#include "structure/joints/sliding_limit.hpp"

namespace fissura::structure {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double>(end - begin).count();
}

CentralDifference dynamics_of(const StructureModel& model, const Geometry& geometry) {
  const Case& given = model.run_case;
  if (!given.bulk_failure.active) return {geometry.body, geometry.tiles, model.moduli, model.threads};
  return {geometry.body, geometry.tiles, model.moduli, rock_failure(given.rock, given.bulk_failure),
          model.threads};
}

void require_finite(double kinetic_energy, double time) {
  if (!std::isfinite(kinetic_energy))
    throw SolverError(fmt::format(
        "the motion of the rock is no longer finite at {} s: lower dynamics.safety_factor", time));
}

}  // namespace

StructureRun::StructureRun(const StructureModel& model, const Geometry& geometry)
    : model_(model),
      geometry_(geometry),
      dynamics_(dynamics_of(model, geometry)),
      joints_(geometry.mesh, geometry.joint_nodes, model.threads),
      sliding_limits_(sliding_limits(geometry.mesh)) {}

std::uint64_t StructureRun::advance(double begin, double end, StructureState& state) {
  const auto steps =
      static_cast<std::uint64_t>(std::ceil((end - begin) / stable_step(model_, geometry_, state)));
  const JointNodes joint_nodes{dynamics_.joint_force(), geometry_.joint_nodes, geometry_.body.mass,
                               state.body.displacement, state.body.velocity};
  Step step{(end - begin) / static_cast<double>(steps), begin, state.mass_scaling.scale(),
            model_.run_case.dynamics.damping};
  const ObservedRock rock = observed_rock(model_, geometry_, state);
  state.sources.begin_interval(rock, begin, state.joints);
  for (std::uint64_t k = 1; k <= steps; ++k) {
    const double tau = static_cast<double>(k) / static_cast<double>(steps);
    step.end = begin + tau * (end - begin);
    const Clock::time_point start = Clock::now();
    dynamics_.advance(state.body, step);  // Sect. 3.6, Eq. 8
    const Clock::time_point middle = Clock::now();
    state.sources.watch(rock, tau, step.size);  // what fails is a source (Sect. 4)
    joints_.advance(joint_nodes, {step.size, step.mass_scale, step.damping, tau}, state.joints);  // Eqs. 11, 18-22
    loop_times_.elements += seconds_between(start, middle);
    loop_times_.joints += seconds_between(middle, Clock::now());
    note_progress("explicit steps");
  }
  state.sources.end_interval(rock, {begin, end, steps, step.mass_scale}, state.joints);
  kinetic_energy_ = structure::kinetic_energy(geometry_.body, state.body.velocity, step.mass_scale);
  require_finite(kinetic_energy_, end);
  require_facing_pairs(geometry_.mesh, state.joints, sliding_limits_);
  return steps;
}

void scale_masses(const StructureModel& model, const Geometry& geometry, double begin, double end,
                  StructureState& state) {
  for (const Stage& stage : model.run_case.injection.stages)
    if (stage.begin > 0 && stage.begin > begin && stage.begin <= end)
      state.mass_scaling.note_pump_event(stage.begin, stage.ramp);
  state.mass_scaling.update(end, connected_half_length(geometry.network));
}

double failure_work(const StructureModel& model, const Geometry& geometry, const StructureState& state) {
  const Case& given = model.run_case;
  if (!given.bulk_failure.active) return 0;
  return state.failure_work_gone + failure_dissipation(geometry.mesh,
                                                       rock_failure(given.rock, given.bulk_failure),
                                                       damage_records(geometry.tiles, state.body.damage));
}

}  // namespace fissura::structure
