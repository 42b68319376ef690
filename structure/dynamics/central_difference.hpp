// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "structure/dynamics/body.hpp"
#include "structure/dynamics/damage_state.hpp"
#include "structure/dynamics/element_loop.hpp"
#include "structure/dynamics/node_motion.hpp"
#include "structure/dynamics/tiles.hpp"

/// Explicit steps of the rock by central differences (node_motion.hpp). Nodes of joints are left to the joint
/// law.
namespace fissura::structure {

/// What the dynamics change. Vectors are interleaved x, y per node of the mesh.
struct State {
  std::vector<double> displacement;  ///< at the step [m]
  std::vector<double> velocity;      ///< at the half step before it [m/s]
  Damage damage;                     ///< empty without bulk failure
};

/// At rest at the in-situ state, of an elastic body.
State state_at_rest(const Body& body);

/// The same of a body that can fail, undamaged.
State state_at_rest(const Body& body, const Tiles& tiles);

class CentralDifference {
 public:
  /// Elastic body. `body` and `tiles` must outlive this and are read in every step. `threads` >= 1; the
  /// result is the same for any number.
  CentralDifference(const Body& body, const Tiles& tiles, const Elasticity& moduli, int threads);

  /// Body that also fails. Its State has a damage state.
  CentralDifference(const Body& body, const Tiles& tiles, const Elasticity& moduli, const RockFailure& law,
                    int threads);

  /// Moves every node but the joint nodes by one step and computes the forces on the joint nodes.
  void advance(State& state, const Step& step);

  /// Force on each joint node before the last step's motion, internal and external, undamped, in the order of
  /// `Tiles::joint.node`, interleaved x, y [N/m].
  [[nodiscard]] const std::vector<double>& joint_force() const { return joint_force_; }

 private:
  void advance_tile(std::size_t t, State& state, StepFactors factors, TileWorkspace& workspace);
  void advance_shared_node(std::size_t i, State& state, StepFactors factors) const;
  void gather_joint_force(std::size_t i);

  const Body& body_;
  const Tiles& tiles_;
  Elasticity moduli_;
  std::optional<RockFailure> law_;
  double lowest_strength_ = 0;
  std::vector<std::array<double, 2>> slot_force_;
  std::vector<double> joint_force_;
  std::vector<TileWorkspace> workspace_;
};

}  // namespace fissura::structure
