// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "structure/structure_state.hpp"

namespace fissura::structure {

/// Everything a structure needs to go on bit for bit on the mesh of its case.
struct Snapshot {
  double time = 0;                    ///< [s]
  std::uint64_t steps = 0;            ///< explicit steps so far
  std::vector<Insertion> insertions;  ///< the history of the network, from revision 0
  StructureState state;
};

std::vector<std::byte> save_snapshot(const Snapshot& snapshot, const Geometry& geometry);

/// Throws Error(checkpoint_unusable) if the bytes do not belong to this geometry. `pattern` is any state of it.
Snapshot restore_snapshot(const std::vector<std::byte>& bytes, const Geometry& geometry,
                          const StructureState& pattern);

}  // namespace fissura::structure
