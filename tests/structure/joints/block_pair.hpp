// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "structure/joints/joint_step.hpp"

namespace fissura::structure::fakes {

/// Two point masses that touch along one contact unit: the smallest body with a joint. The unit's normal is +y.
class BlockPair {
 public:
  BlockPair(const JointProperties& properties, double mass, double length);

  /// One step under forces on the minus and the plus node [N/m].
  void step(Point force_minus, Point force_plus, const JointStepControls& controls);

  [[nodiscard]] const JointState& state() const { return joints_.state[0]; }
  [[nodiscard]] Point velocity_minus() const { return {velocity_[0], velocity_[1]}; }
  [[nodiscard]] Point velocity_plus() const { return {velocity_[2], velocity_[3]}; }
  void set_velocity_plus(Point velocity);
  void set_ramp(const PressureRamp& ramp) { joints_.ramp[0] = ramp; }
  void hold_as_rock() { joints_.released[0] = 0; }
  Joints& joints() { return joints_; }

 private:
  Mesh mesh_;
  Joints joints_;
  std::vector<NodeIndex> nodes_{0, 1};
  std::vector<double> mass_, displacement_, velocity_;
  JointStep joint_step_;
};

}  // namespace fissura::structure::fakes
