// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/neutral_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "network/content_ledger.hpp"

namespace fissura::network {

namespace {

Exposure exposure_at(double time) {
  if (std::isfinite(time)) return {.begin = time, .end = time, .residence = 0, .front = Front::passed};
  return {.begin = 0, .end = 0, .residence = 0, .front = Front::ahead};
}

LedgerSums sums_of(const FluidLedger& ledger, double thickness) {
  LedgerSums sums;
  sums.in_place = ledger.in_place / thickness;
  sums.found.add(ledger.found / thickness);
  sums.injected.add(ledger.injected / thickness);
  sums.leaked.add(ledger.leaked / thickness);
  sums.reset.add(ledger.reset / thickness);
  return sums;
}

}  // namespace

NeutralFlowState neutral_state(const Model& model, const Graph& graph, const State& state) {
  NeutralFlowState neutral;
  neutral.time = state.time;
  neutral.started = state.started;
  neutral.content = state.content;
  neutral.pressure = state.pressure;
  neutral.leaked = state.leaked;
  for (const Exposure& exposure : state.exposure)
    neutral.exposure_time.push_back(exposure.front == Front::ahead ? std::numeric_limits<double>::infinity()
                                                                   : exposure.begin);
  neutral.contact_pressure = state.contact_pressure;
  neutral.fluid_fraction = state.fluid_fraction;
  neutral.joining = state.joining;
  neutral.well_pressure = state.well_pressure;
  neutral.rate = state.rate * model.thickness;
  neutral.entry_rate = state.stage_entry.rate * model.thickness;
  neutral.entry_pressure = state.stage_entry.pressure;
  neutral.ledger = ledger_report(model, graph, state);
  return neutral;
}

State state_from(const NeutralFlowState& neutral, const Model& model, const Graph& graph) {
  const std::size_t nodes = graph.node_count();
  State state;
  state.time = neutral.time;
  state.started = neutral.started;
  state.content = neutral.content;
  state.pressure = neutral.pressure;
  state.leaked = neutral.leaked;
  state.contact_pressure = neutral.contact_pressure;
  state.fluid_fraction = neutral.fluid_fraction;
  state.joining = neutral.joining;
  state.waived.resize(nodes);
  state.arrived.resize(nodes);
  state.pore_content.resize(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    state.exposure.push_back(exposure_at(neutral.exposure_time[i]));
    const bool filled = neutral.pressure[i] > 0;
    state.filled.push_back(filled ? 1 : 0);
    state.has_been_filled.push_back(filled ? 1 : 0);
    if (state.exposure[i].front == Front::ahead)
      state.pore_content[i] = std::max(0.0, neutral.content[i]);
    else if (model.leak_off.active())
      state.waived[i] =
          std::max(0.0, leak_off_demand(model.leak_off, state.exposure[i], neutral.time) - neutral.leaked[i]);
  }
  state.flux.resize(graph.segment_count());
  state.gradient.resize(graph.segment_count());
  state.perforation_rate.resize(graph.perforations().size());
  state.well_pressure = neutral.well_pressure;
  state.rate = neutral.rate / model.thickness;
  state.stage = neutral.started ? model.schedule.stage_from(neutral.time) : std::nullopt;
  state.stage_entry = {.rate = neutral.entry_rate / model.thickness, .pressure = neutral.entry_pressure};
  state.ledger = sums_of(neutral.ledger, model.thickness);
  return state;
}

}  // namespace fissura::network
