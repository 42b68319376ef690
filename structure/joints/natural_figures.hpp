// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/fracture_network/fracture_network.hpp"
#include "structure/joints/joint_state.hpp"

namespace fissura::structure {

/// What has happened on the natural fractures so far. Slip is the size of the relative sliding, whichever
/// way.
struct NaturalFigures {
  double greatest_slip = 0;   ///< [m]
  double slipped_length = 0;  ///< trace length with more than `counted_slip` [m]
  double opened_length = 0;   ///< trace length whose faces are apart [m]
  double wetted_length = 0;   ///< trace length in the network [m]
  double slip_distance =
      0;  ///< greatest distance of a place with more than `counted_slip` from the nearest other fracture [m]
  double greatest_far_slip =
      0;  ///< greatest slip farther than the given distance from any other fracture [m]
};

inline constexpr double counted_slip = 1e-5;   ///< [m]
inline constexpr double least_opening = 1e-6;  ///< of faces that count as apart [m]

/// @param far  distance from which on a slip counts as far [m]. Other fractures are open slits, and what grew
/// or broke and is in the network.
NaturalFigures natural_figures(const Mesh& mesh, const Joints& joints, const FractureNetwork& network,
                               double far);

}  // namespace fissura::structure
