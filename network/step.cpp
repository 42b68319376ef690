// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/step.hpp"

#include <algorithm>
#include <cmath>

#include "network/laws/cubic_law.hpp"
#include "network/laws/fluid_mixture.hpp"

namespace fissura::network {

namespace {

/// Amounts of the fluids in the two cells of a segment; of cells that are both empty the plain mean of what
/// they held.
void fluids_between(const State& state, const SegmentEnds& ends, std::span<double> amounts) {
  const std::size_t count = amounts.size();
  const bool empty = state.content[ends.a] <= 0 && state.content[ends.b] <= 0;
  const double weight_a = empty ? 1 : std::max(0.0, state.content[ends.a]);
  const double weight_b = empty ? 1 : std::max(0.0, state.content[ends.b]);
  for (std::size_t f = 0; f < count; ++f)
    amounts[f] = weight_a * state.fluid_fraction[ends.a * count + f] +
                 weight_b * state.fluid_fraction[ends.b * count + f];
}

void set_storage(const Model& model, const Graph& graph, const Interval& interval, const State& state,
                 Step& step) {
  const double elapsed = step.end - interval.begin;
  for (std::size_t i = 0; i < step.storage.size(); ++i)
    step.storage[i] = {.aperture = std::max(0.0, interval.aperture[i] + interval.aperture_rate[i] * elapsed),
                       .compliance = interval.compliance[i],
                       .reference_pressure = interval.reference_pressure[i],
                       .bulk_modulus = bulk_modulus(model, state, i),
                       .film = model.minimum_aperture,
                       .faces = interval.faces[i],
                       .joint = joint_law(graph, state, i)};
}

/// Of the natural arms at a node [m].
double joint_opening_of_arms(const Graph& graph, const Step& step, const State& state, std::size_t node) {
  const double opening = joint_opening(step.storage[node].joint, state.pressure[node]);
  return opening * graph.lumped_length()[node] / graph.natural_length()[node];
}

void set_segment_apertures(const Model& model, const Graph& graph, const Interval& interval,
                           const State& state, Step& step) {
  const bool per_arm = !interval.arm_aperture_a.empty();
  for (std::size_t s = 0; s < graph.segment_count(); ++s) {
    const auto [a, b] = graph.ends()[s];
    double aperture_a = per_arm ? interval.arm_aperture_a[s] : interval.aperture[a];
    double aperture_b = per_arm ? interval.arm_aperture_b[s] : interval.aperture[b];
    if (graph.network().segments()[s].kind == SegmentKind::natural) {
      aperture_a += joint_opening_of_arms(graph, step, state, a);
      aperture_b += joint_opening_of_arms(graph, step, state, b);
    }
    step.segment_aperture[s] = segment_aperture(aperture_a, aperture_b, model.minimum_aperture);
  }
}

void set_demand(const Model& model, const State& state, Step& step) {
  std::fill(step.demand.begin(), step.demand.end(), 0.0);
  if (!model.leak_off.active()) return;
  for (std::size_t i = 0; i < step.demand.size(); ++i)
    step.demand[i] = std::max(0.0, leak_off_demand(model.leak_off, state.exposure[i], step.end) -
                                       (state.leaked[i] + state.waived[i]));
}

WellTarget well_target(const Model& model, const State& state, double end) {
  if (!state.stage) return {WellControl::rate, 0};
  const PumpingStage& stage = model.schedule.stages()[*state.stage];
  if (stage.control == WellControl::pressure)
    return {stage.control, target_at(stage, state.stage_entry, end)};
  return {stage.control, mean_target(stage, state.stage_entry, state.time, end)};
}

}  // namespace

double bulk_modulus(const Model& model, const State& state, std::size_t node) {
  if (model.single_fluid()) return model.fluids.front().bulk_modulus;
  const std::size_t count = model.fluids.size();
  std::vector<double> moduli;
  for (const FractureFluid& fluid : model.fluids) moduli.push_back(fluid.bulk_modulus);
  return mixture_bulk_modulus(std::span(state.fluid_fraction).subspan(node * count, count), moduli);
}

JointLaw joint_law(const Graph& graph, const State& state, std::size_t node) {
  const NetworkNode& given = graph.network().nodes()[node];
  return {given.joint_compliance, given.formation_pressure, state.contact_pressure[node]};
}

void follow_contact(const Interval& interval, State& state) {
  for (std::size_t i = 0; i < state.contact_pressure.size(); ++i)
    if (interval.faces[i] == Faces::in_contact && state.pressure[i] <= state.contact_pressure[i])
      state.contact_pressure[i] = std::max(interval.reference_pressure[i], state.pressure[i]);
}

void prepare_step(const Model& model, const Graph& graph, const Interval& interval, const State& state,
                  double end, Step& step) {
  step.begin = state.time;
  step.end = end;
  step.storage.resize(graph.node_count());
  step.demand.resize(graph.node_count());
  step.segment_aperture.resize(graph.segment_count());
  step.transmissibility.resize(graph.segment_count());
  set_storage(model, graph, interval, state, step);
  set_demand(model, state, step);
  set_segment_apertures(model, graph, interval, state, step);
  set_transmissibility(model, graph, state, state.gradient, state.flux, step);
  step.well = well_target(model, state, end);
}

void set_transmissibility(const Model& model, const Graph& graph, const State& state,
                          std::span<const double> gradient, std::span<const double> flux, Step& step) {
  const std::size_t fluids = model.fluids.size();
  std::vector<double> amounts(fluids), viscosities(fluids);
  const std::vector<NetworkSegment>& segments = graph.network().segments();
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const double aperture = step.segment_aperture[s];
    const double velocity = std::abs(flux[s]) / aperture;
    for (std::size_t f = 0; f < fluids; ++f)
      viscosities[f] = secant_viscosity(model.fluids[f].law, aperture, gradient[s], velocity);
    double viscosity = viscosities.front();
    if (!model.single_fluid()) {
      fluids_between(state, graph.ends()[s], amounts);
      viscosity = mixture_viscosity(amounts, viscosities);
    }
    step.transmissibility[s] = transmissibility(aperture, viscosity, segments[s].length);
  }
}

}  // namespace fissura::network
