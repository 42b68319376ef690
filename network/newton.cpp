// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/newton.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::network {

namespace {

constexpr double just_beyond = 1e-6;

/// From this iteration on a node that would fill waits once more on the unfilled side, which breaks cycles.
constexpr int patience = 40;

double next_unknown(const ContentLaw& law, double u, double change, int iteration) {
  const double next = u + change;
  if (u < 0 && next >= 0) return iteration < patience ? just_beyond : -just_beyond;
  if (u < 0) return next;
  if (iteration < patience)
    if (const auto kink = first_steepening(law, u, std::max(next, 0.0)))
      return next > u ? *kink + just_beyond : *kink - just_beyond;
  return next < 0 ? -just_beyond : next;
}

bool balanced(const Assembly& assembly, double tolerance) {
  return assembly.imbalance <= tolerance * assembly.moved + assembly.round_off;
}

}  // namespace

void initial_unknown(const Graph& graph, const Step& step, const State& state, std::vector<double>& unknown) {
  unknown.resize(graph.pattern().size());
  for (std::size_t i = 0; i < graph.node_count(); ++i)
    unknown[i] = state.filled[i] >= 1
                     ? state.pressure[i] / pressure_scale
                     : std::min(unfilled_unknown(step.storage[i], state.content[i]), -just_beyond);
  unknown.back() = state.well_pressure / pressure_scale;
}

NewtonReport solve_newton(const Model& model, const Graph& graph, const Step& step,
                          std::span<const double> content, const std::function<void()>& each_iteration,
                          LinearSolver& linear, std::vector<double>& unknown, Assembly& assembly) {
  NewtonReport report;
  for (;; ++report.iterations) {
    assemble(model, graph, step, content, unknown, assembly);
    report.converged = balanced(assembly, model.tolerance);
    report.residual = assembly.moved > 0 ? assembly.imbalance / assembly.moved : 0;
    if (report.converged || report.iterations == model.maximum_iterations) return report;
    if (each_iteration) each_iteration();

    std::vector<double>& change = assembly.residual;
    if (linear.solve(assembly.jacobian, change) == LinearSolver::Outcome::singular) return report;
    for (std::size_t i = 0; i < graph.node_count(); ++i)
      unknown[i] = next_unknown(step.storage[i], unknown[i], -change[i], report.iterations);
    unknown.back() -= change.back();
  }
}

}  // namespace fissura::network
