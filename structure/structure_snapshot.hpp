// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/state_blob.hpp"
#include "structure/initial_motion.hpp"
#include "structure/structure_state.hpp"

namespace fissura::structure {

/// What a structure remembers of its run beside geometry and state.
struct StructureHistory {
  double time = 0;                                 ///< of the last coupling [s]
  std::uint64_t steps = 0;                         ///< explicit steps so far
  std::vector<Insertion> insertions;               ///< all so far, from revision 0
  Equilibration equilibration;                     ///< before time 0
  std::optional<std::uint64_t> reported_geometry;  ///< number of the last one whose mesh went into a report
};

/// Whose state that of a structure is.
StateOwner structure_owner(const Case& run_case);

/// Everything a structure needs to go on bit for bit. @param wet  elements whose in-situ state the fluid of a
/// tip has changed, ascending
std::vector<std::byte> save_snapshot(const StateOwner& owner, const StructureHistory& history,
                                     const Geometry& geometry, const StructureState& state,
                                     const std::vector<ElementIndex>& wet);

struct Snapshot {
  StructureHistory history;
  Geometry geometry;  ///< with its network
  StructureState state;
  std::vector<ElementIndex> wet;
};

/// Throws Error(checkpoint_unusable) if the bytes do not belong to this owner, or no structure could have
/// given them.
Snapshot restore_snapshot(const std::vector<std::byte>& bytes, const StateOwner& owner,
                          const StructureModel& model);

}  // namespace fissura::structure
