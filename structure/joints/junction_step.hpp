// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "structure/joints/joint_state.hpp"

namespace fissura::structure {

/// The nodes of all contact units as one explicit step sees them.
struct JointNodes {
  std::span<const double> force;     ///< internal + external without fluid pressure, undamped [N/m], x y of each node of `index`
  std::span<const NodeIndex> index;  ///< joint nodes in the order of `force`
  std::span<const double> mass;      ///< unscaled lumped mass of every node of the mesh [kg/m]
  std::span<double> displacement;    ///< of every node, x y [m]
  std::span<double> velocity;        ///< of every node at the last half step, x y [m/s]
};

struct JointStepControls {
  double step = 0;        ///< [s]
  double mass_scale = 1;  ///< [-]
  double damping = 0;     ///< lambda of Cundall's local damping [-]
  double tau = 0;         ///< place of the end of the step in the coupling interval, (0, 1]
};

/// Positions of a unit's nodes in JointNodes::force.
struct NodePlaces {
  std::uint32_t minus = 0, plus = 0;
};

/// The velocities at fracture junctions, where several contact units share nodes: sweeps of impulses over the units until the
/// contact conditions of all of them hold together.
class JunctionStep {
 public:
  JunctionStep() = default;
  /// @param units  the units that share nodes, in order;  @param places  of every unit of the mesh
  JunctionStep(std::vector<UnitIndex> units, std::span<const NodePlaces> places);

  /// Advances the velocities of the junctions' nodes; sets closed, held_normal and held_tangential of the units.
  void advance_velocities(const Mesh& mesh, const JointNodes& nodes, const JointStepControls& controls, Joints& joints);

 private:
  std::vector<UnitIndex> units_;
  std::vector<NodePlaces> place_;      ///< per entry of units_
  std::vector<std::uint32_t> nodes_;   ///< places of the nodes of units_, ascending
  std::vector<double> load_;           ///< per joint node, x y: force with pressure and cohesion [N/m]
};

}  // namespace fissura::structure
