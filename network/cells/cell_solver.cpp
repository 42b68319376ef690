// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/cells/cell_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <unordered_map>
#include <utility>

#include "common/errors.hpp"

namespace fissura::cells {

namespace {

/// How far below zero another solver's content may be [m].
constexpr double rounding_of_content = 1e-12;

/// What stands on a cell that changed its length: a cell that grows spreads it; one that shrinks gives the
/// share of the lost length to the new cells beside it, by their lengths.
void spread(std::size_t cell, double old_length, const std::vector<double>& length,
            const std::vector<std::size_t>& receivers, std::vector<double>& values) {
  if (length[cell] >= old_length || receivers.empty()) {
    values[cell] *= old_length / length[cell];
    return;
  }
  double receiving = 0;
  for (const std::size_t receiver : receivers) receiving += length[receiver];
  for (const std::size_t receiver : receivers)
    values[receiver] += values[cell] * (old_length - length[cell]) / receiving;
}

}  // namespace

void CellSolver::join(const FlowCase& flow_case) {
  case_ = flow_case;
  schedule_ = Schedule(flow_case.stages);
}

void CellSolver::take_network(const FractureNetwork& network) {
  length_.clear();
  ends_.clear();
  segment_length_.clear();
  perforations_.clear();
  for (const NetworkNode& node : network.nodes()) length_.push_back(node.lumped_length);
  for (const NetworkSegment& segment : network.segments()) {
    ends_.push_back({network.index_of(segment.node_a), network.index_of(segment.node_b)});
    segment_length_.push_back(segment.length);
  }
  for (const PerforationNode& perforation : network.perforations())
    perforations_.push_back(network.index_of(perforation.node));
  prepare();
}

void CellSolver::insert(const Insertion& insertion, const FractureNetwork& network) {
  const std::vector<double> old_length = length_;
  const std::size_t old_count = old_length.size();
  take_network(network);

  for (auto* values : {&state_.content, &state_.pressure, &state_.filled, &state_.leaked, &state_.aperture})
    values->resize(length_.size(), 0.0);
  std::vector<std::size_t> entered;
  for (std::size_t i = old_count; i < length_.size(); ++i) {
    const double exposed = network.nodes()[i].exposure_time;
    state_.sweep.push_back({.begin = exposed, .end = exposed});
    if (insertion.revision > 0) entered.push_back(i);
    state_.contact_pressure.push_back(network.nodes()[i].formation_pressure);
    state_.joining.push_back(network.nodes()[i].saturated ? 1 : 0);
  }
  for (std::size_t i = 0; i < old_count; ++i) {
    if (length_[i] == old_length[i]) continue;
    std::vector<std::size_t> receivers;
    for (const auto [a, b] : ends_) {
      if (a == i && b >= old_count) receivers.push_back(b);
      if (b == i && a >= old_count) receivers.push_back(a);
    }
    spread(i, old_length[i], length_, receivers, state_.content);
    spread(i, old_length[i], length_, receivers, state_.leaked);
  }
  sweep(std::move(entered), network, state_.time);
  take_segments(network);
}

void CellSolver::sweep(std::vector<std::size_t> cells, const FractureNetwork& network, double latest) {
  std::vector<Sweep>& sweeps = state_.sweep;
  std::ranges::stable_sort(cells, std::less{}, [&](std::size_t i) { return sweeps[i].begin; });
  for (const std::size_t cell : cells) {
    std::vector<std::size_t> neighbours;
    for (const auto [a, b] : ends_) {
      if (a == cell) neighbours.push_back(b);
      if (b == cell) neighbours.push_back(a);
    }
    enter(cell, neighbours, sweeps);
  }
  for (std::size_t i = 0; i < sweeps.size(); ++i)
    if (std::isinf(sweeps[i].end) && network.nodes()[i].role != NodeRole::tip)
      sweeps[i].end = std::max(sweeps[i].begin, latest);
}

/// Fluxes stay with their segments.
void CellSolver::take_segments(const FractureNetwork& network) {
  std::unordered_map<SegmentId, double> flux;
  for (std::size_t s = 0; s < state_.segment.size(); ++s) flux[state_.segment[s]] = state_.flux[s];
  state_.segment.clear();
  state_.flux.clear();
  for (const NetworkSegment& segment : network.segments()) {
    state_.segment.push_back(segment.id);
    state_.flux.push_back(flux.contains(segment.id) ? flux[segment.id] : 0);
  }
}

FlowAnswer CellSolver::advance(const CouplingInterval& interval) {
  interval_ = &interval;
  state_.time = interval.begin;
  state_.aperture = interval.aperture;
  int iterations = 0;
  if (case_.dry) {
    state_.started = true;
    state_.time = interval.end;
  } else {
    if (!state_.started) start();
    if (interval.carry == Carry::pressure) reset_content();
  }
  while (state_.time < interval.end) {
    enter_stage();
    const double end = std::min(interval.end, schedule_.next_change(state_.time).value_or(interval.end));
    set_laws(state_.time);
    iterations += cover(end);
    state_.time = end;
  }
  set_laws(interval.end);
  for (std::size_t i = 0; i < length_.size() && !case_.dry; ++i)
    state_.filled[i] = cell_filled(laws_[i], state_.pressure[i], state_.content[i]);
  return answer(iterations);
}

void CellSolver::start() {
  state_.started = true;
  state_.content = interval_->aperture;
  state_.filled.assign(length_.size(), 1.0);
  state_.in_place = in_fractures();
}

void CellSolver::reset_content() {
  const double before = in_fractures(), modulus = case_.fluids.front().bulk_modulus;
  for (std::size_t i = 0; i < length_.size(); ++i)
    state_.content[i] = state_.filled[i] * interval_->aperture[i] * (1 + state_.pressure[i] / modulus);
  state_.reset.add(in_fractures() - before);
}

void CellSolver::enter_stage() {
  const auto stage = schedule_.stage_from(state_.time);
  if (!stage || (state_.stage && *stage == *state_.stage)) return;
  state_.stage = *stage;
  state_.stage_entry = {.rate = state_.rate, .pressure = state_.well_pressure};
}

void CellSolver::set_laws(double time) {
  laws_.resize(length_.size());
  if (case_.dry) return;
  for (std::size_t i = 0; i < laws_.size(); ++i)
    laws_[i] = {.aperture = std::max(
                    0.0, interval_->aperture[i] + interval_->aperture_rate[i] * (time - interval_->begin)),
                .compliance = interval_->compliance[i],
                .reference_pressure = interval_->reference_pressure[i],
                .bulk_modulus = case_.fluids.front().bulk_modulus,
                .closed = interval_->closed[i] != 0};
}

WellDemand CellSolver::well_demand(double begin, double end) const {
  if (!state_.stage) return {};
  const PumpingStage& stage = case_.stages[*state_.stage];
  if (stage.control == WellControl::pressure)
    return {stage.control, target_at(stage, state_.stage_entry, end)};
  return {stage.control, mean_target(stage, state_.stage_entry, begin, end)};
}

double CellSolver::leak_off_demand(std::size_t cell, double time) const {
  const network::CarterLaw law{case_.leak_off_coefficient, case_.spurt_volume};
  if (!law.active()) return 0;
  return std::max(0.0, leak_off_of(law, state_.sweep[cell], time) - state_.leaked[cell]);
}

void CellSolver::keep_piece(const PieceOfFlow& piece) {
  double injected = 0, leaked = 0, pressures = 0, rate = 0;
  for (const double volume : piece.brought) injected += volume;
  for (std::size_t i = 0; i < length_.size(); ++i) {
    state_.leaked[i] += piece.taken[i];
    leaked += length_[i] * piece.taken[i];
  }
  state_.injected.add(case_.thickness * injected);
  state_.leaked_in_all.add(case_.thickness * leaked);
  for (const double flow : piece.last_rate) rate += flow;
  for (const std::size_t cell : perforations_) pressures += state_.pressure[cell];

  const auto count = static_cast<double>(perforations_.size());
  if (count == 0) return;
  const bool shut = !state_.stage.has_value();
  const double target = shut ? 0 : target_at(case_.stages[*state_.stage], state_.stage_entry, piece.end);
  if (!shut && case_.stages[*state_.stage].control == WellControl::pressure) {
    state_.rate = rate;
    state_.well_pressure = target;
  } else {
    state_.rate = target;
    state_.well_pressure = (target / case_.well_index + pressures) / count;
  }
}

double CellSolver::in_fractures() const {
  double sum = 0;
  for (std::size_t i = 0; i < length_.size(); ++i) sum += length_[i] * state_.content[i];
  return case_.thickness * sum;
}

FluidLedger CellSolver::ledger() const {
  return {.injected = state_.injected.value(),
          .in_place = state_.in_place,
          .found = state_.found,
          .in_fractures = in_fractures(),
          .leaked = state_.leaked_in_all.value(),
          .reset = state_.reset.value()};
}

FlowAnswer CellSolver::answer(int iterations) const {
  FlowAnswer answer;
  answer.pressure = state_.pressure;
  answer.filled = state_.filled;
  answer.aperture_predicted = interval_->aperture;
  for (std::size_t i = 0; i < length_.size() && !case_.dry; ++i)
    answer.aperture_predicted[i] = cell_aperture(laws_[i], state_.pressure[i]);
  answer.ledger = ledger();
  answer.well_pressure = state_.well_pressure;
  answer.rate = case_.thickness * state_.rate;
  answer.iterations = iterations;
  return answer;
}

std::vector<FlowField> CellSolver::report() const {
  return {{"pressure", "Pa", state_.pressure}, {"aperture", "m", state_.aperture},
          {"filled", "1", state_.filled},      {"content", "m", state_.content},
          {"leaked", "m", state_.leaked},      {"flux", "m2/s", state_.flux}};
}

std::vector<std::byte> CellSolver::save() const {
  return bytes_of(state_);
}

void CellSolver::restore(std::span<const std::byte> bytes, const FractureNetwork& network) {
  state_ = state_from(bytes, network.nodes().size(), network.segments().size(), case_.stages.size());
  take_network(network);
}

NeutralFlowState CellSolver::neutral_state() const {
  NeutralFlowState neutral{.time = state_.time,
                           .started = state_.started,
                           .content = state_.content,
                           .pressure = state_.pressure,
                           .leaked = state_.leaked,
                           .exposure_time = {},
                           .contact_pressure = state_.contact_pressure,
                           .fluid_fraction = std::vector<double>(length_.size() * case_.fluids.size(), 0.0),
                           .joining = state_.joining,
                           .well_pressure = state_.well_pressure,
                           .rate = case_.thickness * state_.rate,
                           .entry_rate = case_.thickness * state_.stage_entry.rate,
                           .entry_pressure = state_.stage_entry.pressure,
                           .ledger = ledger()};
  for (const Sweep& sweep : state_.sweep) neutral.exposure_time.push_back(sweep.begin);
  for (std::size_t i = 0; i < neutral.fluid_fraction.size(); i += case_.fluids.size())
    neutral.fluid_fraction[i] = 1;
  return neutral;
}

void CellSolver::take_up(const NeutralFlowState& neutral, const FractureNetwork& network) {
  for (std::size_t i = 0; i < neutral.content.size(); ++i)
    if (neutral.content[i] < -rounding_of_content || neutral.leaked[i] < 0)
      throw Error(
          ExitCode::checkpoint_unusable,
          fmt::format("the neutral state of node {} holds {} m and has leaked {} m, expected at least 0",
                      network.nodes()[i].id, neutral.content[i], neutral.leaked[i]));
  state_ = {};
  take_network(network);
  take_segments(network);
  const std::size_t count = length_.size();
  state_.time = neutral.time;
  state_.started = neutral.started;
  state_.content = neutral.content;
  for (double& content : state_.content) content = std::max(0.0, content);
  state_.pressure = neutral.pressure;
  state_.filled.resize(count);
  for (std::size_t i = 0; i < count; ++i) state_.filled[i] = neutral.pressure[i] > 0 ? 1 : 0;
  state_.leaked = neutral.leaked;
  for (const double exposed : neutral.exposure_time)
    state_.sweep.push_back({.begin = exposed, .end = exposed});
  std::vector<std::size_t> entered;
  for (std::size_t i = 0; i < count; ++i)
    if (neutral.exposure_time[i] > std::ranges::min(neutral.exposure_time)) entered.push_back(i);
  sweep(std::move(entered), network, neutral.time);
  state_.contact_pressure = neutral.contact_pressure;
  state_.joining = neutral.joining;
  state_.aperture.resize(count, 0.0);
  state_.well_pressure = neutral.well_pressure;
  state_.rate = neutral.rate / case_.thickness;
  state_.in_place = neutral.ledger.in_place;
  state_.found = neutral.ledger.found;
  state_.injected.sum = neutral.ledger.injected;
  state_.leaked_in_all.sum = neutral.ledger.leaked;
  state_.reset.sum = neutral.ledger.reset;
  // A stage that begins just now has not been entered.
  const auto stage =
      schedule_.stage_from(std::nextafter(neutral.time, -std::numeric_limits<double>::infinity()));
  if (!stage || !neutral.started) return;
  state_.stage = *stage;
  state_.stage_entry = {.rate = neutral.entry_rate / case_.thickness, .pressure = neutral.entry_pressure};
}

}  // namespace fissura::cells
