// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "network/exposure.hpp"
#include "network/flow.hpp"
#include "network/state.hpp"

/// The front of the injected fluid in natural fractures. Pore fluid moves as soon as a natural fracture is
/// connected, but its faces have always been exposed to that: Carter's leak-off begins where injected fluid
/// arrives. The injected fluid pushes the pore fluid before it like a piston.
namespace fissura::network {

/// A node ahead of the front counts what perforations and nodes wetted before bring,
///   a_i += (dt / l_i) sum_j max(0, q_ji)                    [m]
/// and is wetted, at the end of the step, when that has replaced the pore fluid it was found with:
///   a_i > m_i(joining);   at once, if it joined dry.
/// A node that is wetted within the step passes on what is beyond that, as a share of all that came in. To be
/// called with state.time at the end of the step. @param duration  of the step [s]
void advance_wetting_front(const Graph& graph, const Flow& flow, double duration, State& state);

/// The front enters the cells of `nodes` at `time`.
void wet_natural_fractures(const Graph& graph, std::span<const std::size_t> nodes, double time,
                           std::vector<Exposure>& exposures);

}  // namespace fissura::network
