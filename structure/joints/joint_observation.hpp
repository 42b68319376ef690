// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "common/fracture_network/fracture_network.hpp"
#include "structure/joints/joint_state.hpp"

namespace fissura::structure {

/// What the structure tells about every node of the network, in its order, and about its segments, in theirs.
/// Contact units that meet in one node count with their length.
struct JointObservation {
  std::vector<double> aperture;          ///< with the stored aperture of a perforation [m]
  std::vector<double> aperture_rate;     ///< [m/s]
  std::vector<double> pressure_applied;  ///< on the faces in the last step [Pa]
  std::vector<double>
      pressure_opening;  ///< fluid pressure at which the contact would open: t_coh - T_n, at least 0 [Pa]
  std::vector<double> closed;          ///< 1 if all faces touch, else 0
  std::vector<double> broken;          ///< 1 if no cohesion is left, else 0
  std::vector<double> arm_aperture_a;  ///< of every segment, that of its own faces at its end a [m]
  std::vector<double> arm_aperture_b;  ///< and at its end b [m]
};

JointObservation observe_joints(const Mesh& mesh, const Joints& joints, const FractureNetwork& network);

/// Sets the pressure ramp of the units of every network node for the coming interval. @param ramp  one per
/// node of `network`
void set_ramps(const Mesh& mesh, const FractureNetwork& network, const std::vector<PressureRamp>& ramp,
               Joints& joints);

}  // namespace fissura::structure
