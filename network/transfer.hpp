// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "network/graph.hpp"
#include "network/model.hpp"
#include "network/state.hpp"

namespace fissura::network {

/// Applies one change of topology to graph and state together.
/// Content l_i m_i and leaked volume l_i v_i are conserved to rounding: a node that grows spreads what it
/// has; one that shrinks gives the share of the lost length to the new nodes next to it, by their lengths, or
/// keeps it where there are none. A node that joins saturated gets its pore fluid at the next interval, with
/// the first pumped fluid's properties; every other new node starts dry. Throws ProtocolError, leaving both
/// as they were, if the change does not fit.
void insert_and_transfer(const Model& model, const Insertion& insertion, Graph& graph, State& state);

}  // namespace fissura::network
