// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/fracture/mesh_insertion.hpp"

namespace fissura::structure {

/// What the patches of a plan held before, per unit thickness.
struct PatchBefore {
  double mass = 0;                       ///< of all nodes of the mesh [kg/m]
  std::array<double, 2> momentum{};      ///< sum of m v over the nodes of the patches and of what is rewired [kg/s]
  double momentum_scale = 0;             ///< sum of m |v| over them [kg/s]
  double kinetic_energy = 0;             ///< with the scaled mass [J/m]
};

struct TransferBalance {
  double mass_error = 0;      ///< change of the total mass over the total mass [-]
  double momentum_error = 0;  ///< change of the momentum over the sum of m |v| [-]
  double kinetic_energy = 0;  ///< of the same nodes after [J/m]
};

/// Carries displacements and velocities over an insertion: a copy of a node moves as its source; a new node inside the rock as the element it
/// lies in did, so that stresses follow from displacements everywhere. Interpolation alone would change the momentum: the velocities of
/// the new nodes inside a patch are shifted by one vector so that the momentum of each patch stays. All other nodes keep their bits.
class StateTransfer {
 public:
  /// Looks at the patches before the mesh changes.
  StateTransfer(const GrowthPlan& plan, const Geometry& geometry, const StructureState& state);

  /// After mesh and body have changed: extends and fills the state.
  TransferBalance carry_over(const MeshInsertion& insertion, const Geometry& geometry, StructureState& state) const;

  [[nodiscard]] const PatchBefore& before() const { return before_; }

 private:
  const GrowthPlan& plan_;
  PatchBefore before_;
  std::vector<std::vector<NodeIndex>> staying_;            ///< of each patch: nodes around it that are still there after
  std::vector<std::array<double, 2>> momentum_;            ///< of each patch [kg/s]
  std::vector<std::vector<std::array<double, 4>>> value_;  ///< displacement and velocity of every planned node
};

}  // namespace fissura::structure
