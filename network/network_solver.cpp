// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/network_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "common/case/case_json.hpp"
#include "common/fracture_network/insertion_archive.hpp"
#include "network/content_ledger.hpp"
#include "network/transfer.hpp"

namespace fissura::network {

namespace {

Carry carry_named(const std::string& word) {
  if (word == "content") return Carry::content;
  if (word == "pressure") return Carry::pressure;
  throw ProtocolError(fmt::format("carry is \"{}\", expected \"content\" or \"pressure\"", word));
}

void require_not_negative(const std::vector<double>& values, const char* name, const Graph& graph) {
  const auto found = std::find_if(values.begin(), values.end(), [](double value) { return value < 0; });
  if (found == values.end()) return;
  const auto node = static_cast<std::size_t>(found - values.begin());
  throw ValueError(fmt::format("{} of node {} is {}, expected at least 0", name,
                               graph.network().nodes()[node].id, *found));
}

nlohmann::json ledger_to_json(const LedgerReport& ledger) {
  return {{"injected", ledger.injected}, {"in_place", ledger.in_place}, {"found", ledger.found},
          {"leaked", ledger.leaked},     {"reset", ledger.reset},       {"in_fractures", ledger.in_fractures},
          {"residual", ledger.residual}};
}

}  // namespace

NetworkSolver::NetworkSolver() {
  workspace_.each_iteration = [] { note_progress("newton"); };
}

void NetworkSolver::join(const Assignment& assignment) {
  const Case run_case = case_from_json(assignment.run_case);
  model_ = model_from_case(run_case);
  owner_ = network_owner(run_case);
}

std::string NetworkSolver::insert(const Insertion& insertion) {
  insert_and_transfer(model_, insertion, graph_, state_);
  history_.push_back(insertion);
  workspace_.linear.set_pattern(graph_.pattern());
  return graph_.network().topology_hash();
}

Message NetworkSolver::advance(const Message& command) {
  const auto start = std::chrono::steady_clock::now();
  read_interval(command);
  const AdvanceReport report =
      model_.dry ? pass_dry() : network::advance(model_, graph_, interval_, state_, workspace_);
  Message answer = pressure_message(report);
  figures_.intervals += 1;
  figures_.steps += report.steps;
  figures_.iterations += report.newton.iterations;
  figures_.halvings += report.halvings;
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return answer;
}

void NetworkSolver::read_interval(const Message& command) {
  const std::size_t count = graph_.node_count();
  interval_.begin = command.value<double>("begin");
  interval_.end = command.value<double>("end");
  if (!(interval_.end > interval_.begin))
    throw ProtocolError(
        fmt::format("the interval from {} s to {} s has no length", interval_.begin, interval_.end));
  if (state_.started && interval_.begin != state_.time)
    throw ProtocolError(fmt::format("the interval begins at {} s, expected the end of the last one, {} s",
                                    interval_.begin, state_.time));
  interval_.carry = carry_named(command.value<std::string>("carry"));
  interval_.aperture = command.numbers("aperture", count);
  interval_.aperture_rate = command.numbers("aperture_rate", count);
  interval_.reference_pressure = command.numbers("reference_pressure", count);
  interval_.compliance = command.numbers("compliance", count);
  interval_.arm_aperture_a = arm_apertures(command, "arm_aperture_a");
  interval_.arm_aperture_b = arm_apertures(command, "arm_aperture_b");
  require_not_negative(interval_.aperture, "aperture", graph_);
  require_not_negative(interval_.compliance, "compliance", graph_);
  const std::vector<double> closed = command.numbers("closed", count);
  interval_.faces.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    interval_.faces[i] = closed[i] != 0 ? Faces::in_contact : Faces::separated;
}

std::vector<double> NetworkSolver::arm_apertures(const Message& command, const char* name) const {
  if (!command.has("arm_aperture_a") && !command.has("arm_aperture_b")) return {};
  std::vector<double> values = command.numbers(name, graph_.segment_count());
  const auto found = std::find_if(values.begin(), values.end(), [](double value) { return value < 0; });
  if (found == values.end()) return values;
  const auto segment = static_cast<std::size_t>(found - values.begin());
  throw ValueError(fmt::format("{} of segment {} is {}, expected at least 0", name,
                               graph_.network().segments()[segment].id, *found));
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

Message NetworkSolver::pressure_message(const AdvanceReport& report) const {
  std::vector<double> predicted(graph_.node_count());
  for (std::size_t i = 0; i < predicted.size(); ++i) predicted[i] = predicted_aperture(i);
  Message answer(MessageType::pressure);
  answer.body["ledger"] = ledger_to_json(ledger_report(model_, graph_, state_));
  answer.body["well_pressure"] = state_.well_pressure;
  answer.body["rate"] = state_.rate * model_.thickness;
  answer.body["newton"] = {{"converged", report.newton.converged},
                           {"iterations", report.newton.iterations},
                           {"residual", report.newton.residual},
                           {"halvings", report.halvings}};
  answer.add("pressure", "Pa", state_.pressure);
  answer.add("aperture_predicted", "m", predicted);
  answer.add("filled", "1", state_.filled);
  return answer;
}

Message NetworkSolver::report(const Message&) {
  const std::size_t count = graph_.node_count();
  std::vector<double> aperture = interval_.aperture;
  aperture.resize(count, 0.0);
  // Rounding may leave a dry node a hair below zero in the book; a picture shows it dry.
  std::vector<double> content = state_.content;
  for (double& value : content) value = std::max(value, 0.0);
  Message fields(MessageType::fields);
  fields.body["geometry"] = graph_.network().revision();
  fields.add("pressure", "Pa", state_.pressure);
  fields.add("aperture", "m", aperture);
  fields.add("filled", "1", state_.filled);
  fields.add("content", "m", content);
  fields.add("leaked", "m", state_.leaked);
  fields.add("flux", "m2/s", state_.flux);
  if (!model_.dry) fields.add("fluid_fraction", "1", state_.fluid_fraction, count, model_.fluids.size());
  return fields;
}

std::vector<std::byte> NetworkSolver::save() {
  WorkFigures figures = figures_;
  figures.factorisations += workspace_.linear.factorisations();
  return checkpoint_to_bytes(owner_, {history_, state_, interval_.aperture, figures});
}

void NetworkSolver::restore(const std::vector<std::byte>& bytes) {
  Checkpoint checkpoint = checkpoint_from_bytes(bytes, owner_);
  Graph graph(network_after(checkpoint.history));
  require_of(graph, model_, checkpoint);
  LinearSolver linear;
  linear.set_pattern(graph.pattern());
  graph_ = std::move(graph);
  workspace_.linear = std::move(linear);
  history_ = std::move(checkpoint.history);
  state_ = std::move(checkpoint.state);
  interval_ = {};
  interval_.aperture = std::move(checkpoint.aperture);
  figures_ = checkpoint.figures;
}

nlohmann::json NetworkSolver::finish() {
  return {{"seconds", seconds_},
          {"intervals", figures_.intervals},
          {"steps", figures_.steps},
          {"newton_iterations", figures_.iterations},
          {"halvings", figures_.halvings},
          {"factorisations", figures_.factorisations + workspace_.linear.factorisations()}};
}

}  // namespace fissura::network
