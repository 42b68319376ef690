// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "structure/joints/face_pair.hpp"
#include "structure/joints/joint_state.hpp"

namespace fissura::structure {

/// The nodes of all contact units as one explicit step sees them.
struct JointNodes {
  std::span<const double>
      force;  ///< internal + external without fluid pressure, undamped [N/m], x y of each node of `index`
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

/// A unit that shares a node with another one.
struct SharingUnit {
  UnitIndex unit = 0;
  NodePlaces place;
  FacePair pair;  ///< its geometry; masses and loads are set in every step
};

/// Impulses on the faces of a unit [N s/m].
struct FaceImpulses {
  double normal = 0, tangential = 0;
  double change = 0;  ///< greatest one in the last sweep
};

/// What holds the faces of a unit together.
struct Hold {
  bool normal = false, tangential = false;
};

/// Fracture junctions, where several contact units share nodes: sweeps of impulses over the units of one
/// until the contact conditions of all of them hold together. Junctions share no node with each other: each
/// is swept by itself, in any order or at the same time.
class JunctionStep {
 public:
  JunctionStep() = default;
  /// @param units  that share nodes, ascending
  explicit JunctionStep(std::vector<SharingUnit> units);

  /// Number of junctions.
  [[nodiscard]] std::size_t size() const { return junctions_.size(); }

  /// To be called once before the junctions of a step. @param joint_nodes  how many there are
  void prepare(std::size_t joint_nodes) { load_.resize(2 * joint_nodes); }

  /// Advances one junction over a step: its nodes, and the state of its units.
  void advance(std::size_t junction, const JointNodes& nodes, const JointStepControls& controls,
               Joints& joints);

 private:
  struct Range {
    std::size_t begin = 0, end = 0;
  };
  struct Junction {
    Range units, nodes;  ///< in units_ and nodes_
  };

  /// Of the fluid in a junction during a step.
  struct Fluid {
    double pressure = 0;   ///< [Pa]
    double stiffness = 0;  ///< pressure lost per mean opening of the arms [Pa/m]
    double length = 0;     ///< of all arms [m]
  };

  void load(std::size_t junction, const JointNodes& nodes, const JointStepControls& controls, Joints& joints);
  [[nodiscard]] double pressure_of_mean_aperture(const Junction& junction, double tau,
                                                 const Joints& joints) const;
  void resist_fluid(std::size_t junction, const JointNodes& nodes, const JointStepControls& controls,
                    const Joints& joints) const;
  template <class Visit>
  void settle(const Range& units, const Visit& visit);

  std::vector<SharingUnit> units_;    ///< junction by junction
  std::vector<std::uint32_t> nodes_;  ///< places of their nodes, ascending in each junction
  std::vector<Junction> junctions_;
  std::vector<Fluid> fluid_;    ///< per junction
  std::vector<Vector> before_;  ///< velocity before the step, per entry of nodes_ [m/s]
  std::vector<FaceImpulses> impulses_;
  std::vector<Hold> hold_;
  std::vector<double> load_;  ///< per joint node, x y: force with pressure and cohesion [N/m]
};

}  // namespace fissura::structure
