// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

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
  State state;
  std::vector<double> aperture;  ///< of the last interval, which a report shows [m]
  WorkFigures figures;
};

std::vector<std::byte> checkpoint_to_bytes(const Checkpoint& checkpoint);

/// Throws Error(checkpoint_unusable) if no network of this graph and model could have given the bytes.
Checkpoint checkpoint_from_bytes(std::span<const std::byte> bytes, const Graph& graph, const Model& model);

}  // namespace fissura::network
