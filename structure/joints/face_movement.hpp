// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "structure/joints/face_pair.hpp"

namespace fissura::structure {

/// Where faces stand before a step, as far as failure is told by it.
struct FacePlace {
  double opening = 0, sliding = 0, greatest_separation = 0;  ///< [m]
};

inline FacePlace place_of(const JointState& state) {
  return {state.opening, state.sliding, state.greatest_separation};
}

/// Adds what a unit did in a step if it failed in it: touching faces that slid, or faces that moved farther
/// apart than ever while they had cohesion. Everything it needs is in the cache after observe().
/// @param tau  place of the end of the step in the coupling interval; `step` its length [s]
inline void note_failure(const FacePair& pair, const JointProperties& properties, const FacePlace& before,
                         const JointState& state, double tau, double step, FaceMovement& movement) {
  if (state.closed && pair.stuck) return;
  const bool cracks = state.greatest_separation > before.greatest_separation &&
                      !properties.cohesive.broken(before.greatest_separation);
  if (!cracks && !state.closed) return;
  const double opening = (state.opening - before.opening) / pair.flatness,
               sliding = state.sliding - before.sliding;
  const double path = std::sqrt(opening * opening + sliding * sliding);
  if (movement.path == 0) movement.first = tau;
  movement.last = tau;
  movement.path += path;
  movement.path_time += path * tau;
  movement.opening += opening;
  movement.sliding += sliding;
  movement.growth += cracks ? state.greatest_separation - before.greatest_separation : std::abs(sliding);
  movement.peak_rate = std::max(movement.peak_rate, path / step);
  movement.cracked = movement.cracked || cracks;
}

}  // namespace fissura::structure
