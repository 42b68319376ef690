// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/flow_solver/flow_solver.hpp"

/// The neutral state of the network (docs/flow_solvers.md, 6.2) as a part of a checkpoint: what another
/// solver goes on from.
namespace fissura::coupler {

/// Its name among the states.
inline constexpr const char* neutral_network = "network_neutral";

/// Bit for bit.
std::vector<std::byte> neutral_part(const NeutralFlowState& state);

/// The inverse. Throws Error(checkpoint_unusable) if the bytes are no such part, or not of so many nodes and
/// fluids.
NeutralFlowState neutral_state_of(std::span<const std::byte> part, std::size_t nodes, std::size_t fluids);

}  // namespace fissura::coupler
