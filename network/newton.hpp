// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "network/assemble.hpp"
#include "network/linear_solver.hpp"

namespace fissura::network {

struct NewtonReport {
  bool converged = false;
  int iterations = 0;   ///< linear solutions
  double residual = 0;  ///< imbalance over the content moved [-]
};

/// Where Newton starts: the pressures of the last solution (not of the structure: their noise makes a start
/// at rest), and the contents of nodes that were not filled; the well's unknown last.
void initial_unknown(const Graph& graph, const Step& step, const State& state, std::vector<double>& unknown);

/// Semismooth Newton on the unknowns of fluid_content:  J du = -R,  u += du,  where a node that changes
/// between filled and unfilled, or comes to where its content begins to change much faster
/// (first_steepening), is stopped just beyond, so that its new slope is seen before it goes on. Converged
/// when imbalance <= tolerance * moved, or rounding allows no better. On return `assembly` belongs to
/// `unknown`.
/// @param each_iteration  called once per iteration; may be empty
[[nodiscard]] NewtonReport solve_newton(const Model& model, const Graph& graph, const Step& step,
                                        std::span<const double> content,
                                        const std::function<void()>& each_iteration, LinearSolver& linear,
                                        std::vector<double>& unknown, Assembly& assembly);

}  // namespace fissura::network
