// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "structure/structure_state.hpp"

namespace fissura::structure {

/// Everything a structure needs to go on bit for bit, the geometry included if it is no longer that of the case.
struct Snapshot {
  double time = 0;                    ///< [s]
  std::uint64_t steps = 0;            ///< explicit steps so far
  std::vector<Insertion> insertions;  ///< the history of the network, from revision 0
  StructureState state;
};

/// `geometry` is the one that `snapshot.state` belongs to.
std::vector<std::byte> save_snapshot(const Snapshot& snapshot, const Geometry& geometry);

/// Gives `geometry` the geometry at the time of saving, but for its network, which follows from the insertions. It is any geometry of
/// this model. Throws Error(checkpoint_unusable) if the bytes do not belong to this model; then `geometry` is unchanged.
Snapshot restore_snapshot(const std::vector<std::byte>& bytes, const StructureModel& model, Geometry& geometry);

}  // namespace fissura::structure
