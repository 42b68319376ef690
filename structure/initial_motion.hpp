// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "structure/structure_state.hpp"

/// What happens before time 0.
namespace fissura::structure {

/// How the natural fractures came to rest.
struct Equilibration {
  std::uint64_t steps = 0;   ///< explicit steps
  double greatest_slip = 0;  ///< that was needed [m]
  std::string fracture;      ///< where; empty without slip
};

/// Lets the natural fractures slide and open under the in-situ stress, with strong damping and the mass scale
/// of the start, until they rest: no node moves by more than `negligible_motion` in `steps_between_checks`
/// steps. What holds from the start costs one check of a few steps. Slits without strength and rock that can
/// break are held together meanwhile; nothing dilates. Then velocities are zero and slip counts from there;
/// cement that did not break is whole. Does nothing without natural fractures. Throws InputError, naming the
/// fracture that moves most, if they do not come to rest.
Equilibration come_to_rest(const StructureModel& model, const Geometry& geometry, StructureState& state);

inline constexpr double negligible_motion = 1e-9;  ///< [m]
inline constexpr int steps_between_checks = 200;
inline constexpr int most_checks = 200;

/// Sets the initial velocities of the case: of nodes all of whose elements have their centroid in the
/// rectangle, where they are not held.
void start_motion(const StructureModel& model, const Geometry& geometry, StructureState& state);

}  // namespace fissura::structure
