// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/network_solver.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "network/content_ledger.hpp"
#include "network/neutral_state.hpp"
#include "network/transfer.hpp"

namespace fissura::network {

namespace {

Interval interval_from(const CouplingInterval& given) {
  Interval interval{.begin = given.begin,
                    .end = given.end,
                    .carry = given.carry,
                    .aperture = given.aperture,
                    .aperture_rate = given.aperture_rate,
                    .reference_pressure = given.reference_pressure,
                    .compliance = given.compliance,
                    .faces = {},
                    .arm_aperture_a = given.arm_aperture_a,
                    .arm_aperture_b = given.arm_aperture_b};
  for (const unsigned char closed : given.closed)
    interval.faces.push_back(closed != 0 ? Faces::in_contact : Faces::separated);
  return interval;
}

}  // namespace

NetworkSolver::NetworkSolver(std::function<void()> each_iteration) {
  workspace_.each_iteration = std::move(each_iteration);
}

std::set<std::string> NetworkSolver::physics() const {
  return {claims::viscous_flow,     claims::leak_off,          claims::power_law,     claims::several_fluids,
          claims::pressure_control, claims::natural_fractures, claims::carry_pressure};
}

void NetworkSolver::join(const FlowCase& flow_case) {
  model_ = model_from_case(flow_case);
}

void NetworkSolver::insert(const Insertion& insertion, const FractureNetwork&) {
  insert_and_transfer(model_, insertion, graph_, state_);
  workspace_.linear.set_pattern(graph_.pattern());
}

FlowAnswer NetworkSolver::advance(const CouplingInterval& given) {
  const auto start = std::chrono::steady_clock::now();
  interval_ = interval_from(given);
  const AdvanceReport report =
      model_.dry ? pass_dry() : network::advance(model_, graph_, interval_, state_, workspace_);
  FlowAnswer result = answer(report);
  figures_.intervals += 1;
  figures_.steps += report.steps;
  figures_.iterations += report.newton.iterations;
  figures_.halvings += report.halvings;
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

AdvanceReport NetworkSolver::pass_dry() {
  state_.time = interval_.end;
  state_.started = true;
  AdvanceReport report;
  report.newton.converged = true;
  return report;
}

double NetworkSolver::predicted_aperture(std::size_t node) const {
  return model_.dry ? interval_.aperture[node]
                    : network::predicted_aperture(workspace_.step.storage[node], state_.pressure[node]);
}

FlowAnswer NetworkSolver::answer(const AdvanceReport& report) const {
  FlowAnswer answer;
  answer.pressure = state_.pressure;
  for (std::size_t i = 0; i < graph_.node_count(); ++i)
    answer.aperture_predicted.push_back(predicted_aperture(i));
  answer.filled = state_.filled;
  answer.ledger = ledger_report(model_, graph_, state_);
  answer.well_pressure = state_.well_pressure;
  answer.rate = state_.rate * model_.thickness;
  answer.converged = report.newton.converged;
  answer.iterations = report.newton.iterations;
  answer.halvings = report.halvings;
  answer.residual = report.newton.residual;
  return answer;
}

std::vector<FlowField> NetworkSolver::report() const {
  std::vector<double> aperture = interval_.aperture;
  aperture.resize(graph_.node_count(), 0.0);
  // Rounding may leave a dry node a hair below zero in the book; a picture shows it dry.
  std::vector<double> content = state_.content;
  for (double& value : content) value = std::max(value, 0.0);
  std::vector<FlowField> fields{{"pressure", "Pa", state_.pressure, {}}, {"aperture", "m", aperture, {}},
                                {"filled", "1", state_.filled, {}},      {"content", "m", content, {}},
                                {"leaked", "m", state_.leaked, {}},      {"flux", "m2/s", state_.flux, {}}};
  if (!model_.dry) fields.push_back({"fluid_fraction", "1", state_.fluid_fraction, model_.fluids.size()});
  return fields;
}

std::vector<std::byte> NetworkSolver::save() const {
  WorkFigures figures = figures_;
  figures.factorisations += workspace_.linear.factorisations();
  return checkpoint_to_bytes({state_, interval_.aperture, figures});
}

void NetworkSolver::restore(std::span<const std::byte> bytes, const FractureNetwork& network) {
  Graph graph(network);
  Checkpoint checkpoint = checkpoint_from_bytes(bytes, graph, model_);
  stand_on(std::move(graph));
  state_ = std::move(checkpoint.state);
  interval_ = {};
  interval_.aperture = std::move(checkpoint.aperture);
  figures_ = checkpoint.figures;
}

NeutralFlowState NetworkSolver::neutral_state() const {
  return network::neutral_state(model_, graph_, state_);
}

void NetworkSolver::take_up(const NeutralFlowState& neutral, const FractureNetwork& network) {
  stand_on(Graph(network));
  state_ = state_from(neutral, model_, graph_);
  interval_ = {};
}

void NetworkSolver::stand_on(Graph graph) {
  graph_ = std::move(graph);
  workspace_.linear = LinearSolver();
  workspace_.linear.set_pattern(graph_.pattern());
}

nlohmann::json NetworkSolver::finish() const {
  return {{"seconds", seconds_},
          {"intervals", figures_.intervals},
          {"steps", figures_.steps},
          {"newton_iterations", figures_.iterations},
          {"halvings", figures_.halvings},
          {"factorisations", figures_.factorisations + workspace_.linear.factorisations()}};
}

}  // namespace fissura::network
