// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/flow_solver/flow_solver.hpp"
#include "network/graph.hpp"
#include "network/model.hpp"
#include "network/state.hpp"

namespace fissura::network {

/// The state as any flow solver understands it. Not in it: leak-off that is owed or was let go, when a front
/// left a cell, how far it came in a natural fracture, and what iterations begin with.
NeutralFlowState neutral_state(const Model& model, const Graph& graph, const State& state);

/// A state that goes on from `neutral`: the same content and leaked volume, and the same ledger to rounding.
/// Leak-off is owed from here on only. A natural fracture that the injected fluid has not reached counts as
/// full of pore fluid.
State state_from(const NeutralFlowState& neutral, const Model& model, const Graph& graph);

}  // namespace fissura::network
