// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "common/flow_solver/flow_solver.hpp"
#include "network/flow.hpp"
#include "network/state.hpp"

/// The book of the fluid: content is what the fluxes brought, never what an equation of state makes of a
/// pressure, so that nothing is lost whatever the tolerance of the solution.
namespace fissura::network {

/// At the first interval: nodes that joined saturated are full of pore fluid at formation pressure, others
/// with an aperture are filled at zero pressure, all others are dry.
void fill_at_start(const Model& model, const Graph& graph, const Interval& interval, State& state);

/// The pore fluid of the nodes that have joined saturated since the last interval, in the apertures that the
/// structure measured: m = e (1 + p_0 / K_f), p = p_0. What this adds to the content is booked as found.
void find_pore_fluid(const Model& model, const Graph& graph, const Interval& interval, State& state);

/// carry = pressure: content made anew from the aperture e and the last pressure, m = (e + j(p)) (1 + p /
/// K_f) of a filled node and filled * (e + j(p)) of any other; the difference is booked as reset.
void reset_content(const Model& model, const Graph& graph, const Interval& interval, State& state);

/// Takes the step into the state:
///   m_total = m + dt inflow / l;   taken = min(Lambda, m_total);   m = m_total - taken;   v = v + taken
/// A node that had been filled and is now closed and dry lets its unmet demand go, or a later refill would be
/// swallowed. Throws SolverError, with the node and the value, for a pressure or content that is negative or
/// not finite.
void commit_step(const Model& model, const Graph& graph, const Step& step, const Assembly& solution,
                 const Flow& flow, std::span<const double> unknown, State& state);

/// Throws SolverError if the residual is more than `conservation_tolerance` of the largest volume in the
/// book.
FluidLedger ledger_report(const Model& model, const Graph& graph, const State& state);

inline constexpr double conservation_tolerance = 1e-10;

}  // namespace fissura::network
