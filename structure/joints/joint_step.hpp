// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "structure/joints/joint_state.hpp"
#include "structure/joints/junction_step.hpp"

namespace fissura::structure {

/// Integrates the nodes of all contact units over one step: cohesion, fluid pressure, contact as an impulse, Coulomb friction; then
/// opening, sliding and pressure at the end of the step. The stiffness of fluid and cohesion is taken implicitly, so that joints never
/// bind the stable step. Units are visited in their order: the result does not depend on threads.
class JointStep {
 public:
  /// @param joint_nodes  every node of every unit once, in the order of JointNodes::force
  JointStep(const Mesh& mesh, std::span<const NodeIndex> joint_nodes);

  /// @param nodes     force in; displacement and velocity of the joint nodes advanced
  /// @param joints    ramp and released in; state advanced
  void advance(const Mesh& mesh, const JointNodes& nodes, const JointStepControls& controls, Joints& joints);

 private:
  void advance_ordinary(const Mesh& mesh, const JointNodes& nodes, const JointStepControls& controls, UnitIndex unit,
                        Joints& joints) const;

  std::vector<NodePlaces> place_;     ///< per unit
  std::vector<UnitIndex> ordinary_;   ///< units that share no node with another one
  JunctionStep junctions_;            ///< the rest
};

}  // namespace fissura::structure
