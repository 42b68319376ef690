// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/advance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/errors.hpp"
#include "network/fluid_transport.hpp"

namespace fissura::network {

namespace {

class IntervalAdvance {
 public:
  IntervalAdvance(const Model& model, const Graph& graph, const Interval& interval, State& state,
                  Workspace& workspace)
      : model_(model), graph_(graph), interval_(interval), state_(state), work_(workspace) {}

  AdvanceReport run() {
    state_.time = interval_.begin;
    if (!state_.started) fill_at_start(model_, graph_, interval_, state_);
    find_pore_fluid(model_, graph_, interval_, state_);
    follow_contact(interval_, state_);
    if (interval_.carry == Carry::pressure) reset_content(model_, graph_, interval_, state_);
    while (state_.time < interval_.end) {
      enter_stage();
      const double change = model_.schedule.next_change(state_.time).value_or(interval_.end);
      cover(std::min(interval_.end, change), 0);
    }
    return report_;
  }

 private:
  void enter_stage() {
    const auto stage = model_.schedule.stage_from(state_.time);
    if (stage == state_.stage) return;
    state_.stage = stage;
    state_.stage_entry = {.rate = state_.rate, .pressure = state_.well_pressure};
  }

  void cover(double end, int halvings) {
    if (solve(end)) {
      accept();
      return;
    }
    if (halvings == maximum_halvings) give_up(end);
    ++report_.halvings;
    const double middle = 0.5 * (state_.time + end);
    cover(middle, halvings + 1);
    cover(end, halvings + 1);
  }

  bool solve(double end) {
    prepare_step(model_, graph_, interval_, state_, end, work_.step);
    initial_unknown(graph_, work_.step, state_, work_.unknown);
    for (int pass = 0;; ++pass) {
      const NewtonReport newton =
          solve_newton(model_, graph_, work_.step, state_.content, work_.each_iteration, work_.linear,
                       work_.unknown, work_.assembly);
      report_.newton.converged = newton.converged;
      report_.newton.residual = newton.residual;
      report_.newton.iterations += newton.iterations;
      if (!newton.converged) return false;
      flow_of(model_, graph_, work_.step, work_.assembly, work_.flow);
      if (model_.newtonian() || pass == maximum_secant_passes || improve_secants() <= secant_tolerance)
        return true;
    }
  }

  /// Sets new secants and returns how much they would change the fluxes at the pressures found.
  double improve_secants() {
    previous_ = work_.step.transmissibility;
    set_transmissibility(model_, graph_, state_, work_.flow.gradient, work_.flow.flux, work_.step);
    double largest = 0, change = 0;
    for (std::size_t s = 0; s < previous_.size(); ++s) {
      const double flux = std::abs(work_.flow.flux[s]);
      largest = std::max(largest, flux);
      change = std::max(change, flux * std::abs(work_.step.transmissibility[s] / previous_[s] - 1));
    }
    return largest > 0 ? change / largest : 0;
  }

  void accept() {
    move_fluids(model_, graph_, work_.step, work_.assembly, work_.flow, state_);
    commit_step(model_, graph_, work_.step, work_.assembly, work_.flow, work_.unknown, state_);
    state_.rate = rate_at_end();
    ++report_.steps;
  }

  [[nodiscard]] double rate_at_end() const {
    if (!state_.stage) return 0;
    const PumpingStage& stage = model_.schedule.stages()[*state_.stage];
    if (stage.control == WellControl::rate) return target_at(stage, state_.stage_entry, state_.time);
    double sum = 0;
    for (const double rate : state_.perforation_rate) sum += rate;
    return sum;
  }

  [[noreturn]] void give_up(double end) const {
    std::size_t worst = 0;
    for (std::size_t i = 0; i < graph_.node_count(); ++i)
      if (!(std::abs(work_.assembly.residual[i]) <= std::abs(work_.assembly.residual[worst]))) worst = i;
    throw SolverError(
        fmt::format("the fracture flow did not converge from {} s to {} s after {} halvings of the interval: "
                    "relative imbalance {}, "
                    "expected {}, worst at node {} with {} m2",
                    state_.time, end, maximum_halvings, report_.newton.residual, model_.tolerance,
                    graph_.network().nodes()[worst].id, work_.assembly.residual[worst]));
  }

  const Model& model_;
  const Graph& graph_;
  const Interval& interval_;
  State& state_;
  Workspace& work_;
  AdvanceReport report_;
  std::vector<double> previous_;
};

}  // namespace

AdvanceReport advance(const Model& model, const Graph& graph, const Interval& interval, State& state,
                      Workspace& workspace) {
  return IntervalAdvance(model, graph, interval, state, workspace).run();
}

}  // namespace fissura::network
