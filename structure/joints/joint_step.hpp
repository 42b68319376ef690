// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "structure/joints/face_pair.hpp"
#include "structure/joints/joint_state.hpp"
#include "structure/joints/junction_step.hpp"

namespace fissura::structure {

/// Integrates the nodes of all contact units over one step: cohesion, fluid pressure, contact as an impulse,
/// Coulomb friction, dilation; then opening, sliding and pressure at the end of the step. The stiffness of
/// fluid and cohesion is taken implicitly, so that joints never bind the stable step. A unit that shares no
/// node, and a junction, is a matter of its own: the result does not depend on threads.
class JointStep {
 public:
  /// @param joint_nodes  every node of every unit once, in the order of JointNodes::force
  JointStep(const Mesh& mesh, std::span<const NodeIndex> joint_nodes, int threads);

  /// @param nodes     force in; displacement and velocity of the joint nodes advanced
  /// @param joints    ramp and released in; state advanced
  void advance(const JointNodes& nodes, const JointStepControls& controls, Joints& joints);

 private:
  /// A unit that shares no node with another one.
  struct Ordinary {
    UnitIndex unit = 0;
    NodePlaces place;
    FacePair pair;  ///< its geometry
  };

  [[gnu::always_inline]] static void fetch(const Ordinary& entry, const JointNodes& nodes);
  static void advance_ordinary(const Ordinary& entry, const JointNodes& nodes,
                               const JointStepControls& controls, Joints& joints);

  std::vector<Ordinary> ordinary_;
  JunctionStep junctions_;  ///< the rest
  int threads_;
};

}  // namespace fissura::structure
