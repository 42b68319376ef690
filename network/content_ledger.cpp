// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/content_ledger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/errors.hpp"
#include "network/wetting.hpp"

namespace fissura::network {

namespace {

/// A node filled less than this is dry.
constexpr double dry = 0.01;

/// Negative content that the solution's tolerance explains, as a fraction of the smallest aperture that
/// matters.
constexpr double content_noise = 1e-6;

double stored(const Graph& graph, const State& state) {
  double sum = 0;
  for (std::size_t i = 0; i < graph.node_count(); ++i) sum += graph.lumped_length()[i] * state.content[i];
  return sum;
}

double filled_fraction(double content, double aperture) {
  if (aperture <= 0 || content <= 0) return 0;
  return std::min(content / aperture, std::nextafter(1.0, 0.0));
}

void require_physical(double value, double lowest, const char* what, const Graph& graph, std::size_t node,
                      const Step& step) {
  if (std::isfinite(value) && value >= lowest) return;
  throw SolverError(fmt::format("{} of node {} is {} at {} s, expected a finite value of at least 0", what,
                                graph.network().nodes()[node].id, value, step.end));
}

/// Returns the volume added [m2].
double saturate(const Model& model, const Graph& graph, const Interval& interval, State& state) {
  double added = 0;
  for (std::size_t i = 0; i < graph.node_count(); ++i) {
    if (!state.joining[i]) continue;
    const double pressure = graph.network().nodes()[i].formation_pressure;
    const double content = interval.aperture[i] * (1 + pressure / bulk_modulus(model, state, i));
    added += graph.lumped_length()[i] * (content - state.content[i]);
    state.content[i] = state.pore_content[i] = content;
    state.pressure[i] = pressure;
    state.filled[i] = 1;
    state.has_been_filled[i] = 1;
    state.joining[i] = 0;
  }
  return added;
}

}  // namespace

void fill_at_start(const Model& model, const Graph& graph, const Interval& interval, State& state) {
  state.started = true;
  std::vector<std::size_t> wet;
  for (std::size_t i = 0; i < graph.node_count(); ++i) {
    if (state.joining[i] || interval.aperture[i] <= 0) continue;
    state.content[i] = interval.aperture[i];
    state.filled[i] = 1;
    state.has_been_filled[i] = 1;
    if (state.exposure[i].front == Front::ahead) wet.push_back(i);
  }
  (void)saturate(model, graph, interval, state);
  wet_natural_fractures(graph, wet, interval.begin, state.exposure);
  state.ledger.in_place = stored(graph, state);
}

void find_pore_fluid(const Model& model, const Graph& graph, const Interval& interval, State& state) {
  state.ledger.found.add(saturate(model, graph, interval, state));
}

void reset_content(const Model& model, const Graph& graph, const Interval& interval, State& state) {
  const double before = stored(graph, state);
  for (std::size_t i = 0; i < graph.node_count(); ++i) {
    const double opening = joint_opening(joint_law(graph, state, i), state.pressure[i]);
    state.content[i] =
        std::max(0.0, interval.aperture[i] + opening) *
        (state.filled[i] >= 1 ? 1 + state.pressure[i] / bulk_modulus(model, state, i) : state.filled[i]);
  }
  state.ledger.reset.add(stored(graph, state) - before);
}

void commit_step(const Model& model, const Graph& graph, const Step& step, const Assembly& solution,
                 const Flow& flow, std::span<const double> unknown, State& state) {
  const double duration = step.duration();
  const double noise = content_noise * model.minimum_aperture;
  double taken_in_all = 0;
  for (std::size_t i = 0; i < graph.node_count(); ++i) {
    const double length = graph.lumped_length()[i];
    const double total = state.content[i] + duration * flow.inflow[i] / length;
    const double allowance = noise + (model.tolerance * solution.moved + solution.round_off) / length;
    require_physical(solution.pressure[i], 0, "the pressure", graph, i, step);
    require_physical(total, -allowance, "the fluid content", graph, i, step);

    const double taken = std::max(0.0, std::min(step.demand[i], total));
    state.content[i] = total - taken;
    state.leaked[i] += taken;
    taken_in_all += length * taken;
    state.pressure[i] = solution.pressure[i];
    const bool filled = unknown[i] >= 0;
    state.filled[i] = filled ? 1 : filled_fraction(state.content[i], hydraulic_aperture(step.storage[i], 0));
    const bool emptied =
        state.has_been_filled[i] && state.filled[i] < dry && step.storage[i].faces == Faces::in_contact;
    if (emptied) state.waived[i] += step.demand[i] - taken;
    if (filled) state.has_been_filled[i] = 1;
  }
  state.ledger.leaked.add(taken_in_all);
  for (const double rate : flow.perforation_rate) state.ledger.injected.add(duration * rate);
  state.flux = flow.flux;
  state.gradient = flow.gradient;
  state.perforation_rate = flow.perforation_rate;
  state.well_pressure = solution.well_pressure;
  state.time = step.end;
  advance_wetting_front(graph, flow, duration, state);
}

FluidLedger ledger_report(const Model& model, const Graph& graph, const State& state) {
  const double h = model.thickness;
  const FluidLedger report{.injected = h * state.ledger.injected.value(),
                           .in_place = h * state.ledger.in_place,
                           .found = h * state.ledger.found.value(),
                           .in_fractures = h * stored(graph, state),
                           .leaked = h * state.ledger.leaked.value(),
                           .reset = h * state.ledger.reset.value()};
  const double largest = std::max(
      {std::abs(report.injected), report.in_place, report.found, report.in_fractures, report.leaked});
  if (std::abs(report.residual()) > conservation_tolerance * largest)
    throw SolverError(fmt::format("fluid is not conserved at {} s: {} m3 of {} m3 are missing", state.time,
                                  report.residual(), largest));
  return report;
}

}  // namespace fissura::network
