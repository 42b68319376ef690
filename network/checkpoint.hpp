// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/state_blob.hpp"
#include "network/graph.hpp"
#include "network/model.hpp"
#include "network/state.hpp"

namespace fissura::network {

/// Work done so far.
struct WorkFigures {
  std::int64_t intervals = 0, steps = 0, iterations = 0, halvings = 0, factorisations = 0;
};

/// Everything a network solver needs to go on bit for bit.
struct Checkpoint {
  std::vector<Insertion> history;  ///< the graph, from revision 0
  State state;
  std::vector<double> aperture;  ///< of the last interval, which a report shows [m]
  WorkFigures figures;
};

/// Whose state that of a network is.
StateOwner network_owner(const Case& run_case);

std::vector<std::byte> checkpoint_to_bytes(const StateOwner& owner, const Checkpoint& checkpoint);

/// Throws Error(checkpoint_unusable) if the bytes do not belong to this owner, or no network could have given
/// them.
Checkpoint checkpoint_from_bytes(std::span<const std::byte> bytes, const StateOwner& owner);

/// Throws Error(checkpoint_unusable) unless the state has the size of this network and names what this model
/// has.
void require_of(const Graph& graph, const Model& model, const Checkpoint& checkpoint);

}  // namespace fissura::network
