// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "network/content_ledger.hpp"
#include "network/newton.hpp"
#include "network/step.hpp"

namespace fissura::network {

/// An interval is halved at most this often before the run ends.
inline constexpr int maximum_halvings = 12;

/// Solutions with improved secants that a power-law fluid may take in one step, and the change of flux at
/// which they are good enough, as a fraction of the largest flux. What is left then lags by one step.
inline constexpr int maximum_secant_passes = 20;
inline constexpr double secant_tolerance = 0.01;

/// Memory that lasts from call to call, so that a step allocates nothing while the graph stands. Carries no
/// state.
struct Workspace {
  LinearSolver linear;  ///< set_pattern belongs to whoever changes the graph
  Step step;
  Assembly assembly;
  Flow flow;
  std::vector<double> unknown;
  std::function<void()> each_iteration;  ///< called in every Newton iteration
};

struct AdvanceReport {
  NewtonReport newton;  ///< of the last step; iterations of all
  int halvings = 0;
  int steps = 0;
};

/// Advances the state over one coupling interval. It is cut at changes of the pumping schedule; a step whose
/// Newton iteration fails is never accepted but halved. Throws SolverError when it has been halved
/// maximum_halvings times, or when a result is not physical.
AdvanceReport advance(const Model& model, const Graph& graph, const Interval& interval, State& state,
                      Workspace& workspace);

}  // namespace fissura::network
