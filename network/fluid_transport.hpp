// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "network/flow.hpp"
#include "network/state.hpp"

namespace fissura::network {

/// Moves the fluids with the flow of a step: implicit upwind, so that each cell ends with the mixture of what
/// it held and what came in,
///   c_i = (l_i m_i c_i + dt sum_in f c_upstream) / (l_i m_i + dt sum_in f),
/// and everything that leaves it (flux, leak-off, production) has that mixture. Flow goes down the pressure,
/// the well included, so one sweep in the order of falling pressure solves this exactly for any step. Fluids
/// are conserved as the content is. To be called before commit_step, with the content of the begin of the
/// step. Does nothing for a single fluid.
void move_fluids(const Model& model, const Graph& graph, const Step& step, const Assembly& solution,
                 const Flow& flow, State& state);

}  // namespace fissura::network
