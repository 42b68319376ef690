// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "common/fracture_network/fracture_network.hpp"
#include "structure/dynamics/body.hpp"
#include "structure/dynamics/central_difference.hpp"
#include "structure/dynamics/frequency_bound.hpp"
#include "structure/material/elasticity.hpp"
#include "structure/dynamics/mass_scaling.hpp"
#include "structure/dynamics/tiles.hpp"
#include "structure/fracture/crossing_seed.hpp"
#include "structure/joints/joint_state.hpp"
#include "structure/mesh/mesh.hpp"
#include "structure/mesh/mesh_change.hpp"
#include "structure/mesh/node_elements.hpp"
#include "structure/seismicity/source_observer.hpp"

/// The three rates of change of the structure: model (never), geometry (at coupling times), state (every step).
namespace fissura::structure {

/// Never changes after it is built.
struct StructureModel {
  Case run_case;
  Elasticity moduli;
  int threads = 1;
};

/// Mesh, everything derived from it, and the part of its fractures that is connected to the fluid.
struct Geometry {
  Mesh mesh;
  NodeElements node_elements;
  Body body;
  std::vector<NodeIndex> joint_nodes;
  Tiles tiles;
  FrequencyBound frequency_bound;
  double frequency_squared = 0;  ///< of the stiffest element, unscaled [1/s2]
  std::uint64_t number = 0;      ///< grows with every change of the mesh
  FractureNetwork network;
};

/// Changes in every explicit step.
struct StructureState {
  State body;
  Joints joints;
  MassScaling mass_scaling;  ///< changes at coupling times only
  /// Work of failure that insertions took out of the elements and did not give to the cohesion of the faces; may be negative. With it the
  /// work of failure and cohesion together goes on without a jump. Changes at coupling times only. [J/m]
  double failure_work_gone = 0;
  std::vector<CrossingSeed> crossing_seeds;  ///< change at coupling times only
  SourceObserver sources;                    ///< of microseismicity
};

/// Meshes the case and builds everything that depends on the mesh. Throws InputError if it cannot be meshed.
Geometry build_geometry(const StructureModel& model);

/// After `geometry.mesh` changed: everything built from it follows where it was touched, and the number of the geometry grows. The
/// network is not touched, nor is any state: damage is kept by place in a tile, so carry its records to the new tiles. Throws SolverError
/// if an element has no area, InputError if a fracture reached a side with a prescribed displacement.
void follow(const StructureModel& model, const MeshChange& change, Geometry& geometry);

/// In-situ equilibrium at rest.
StructureState initial_state(const StructureModel& model, const Geometry& geometry);

/// Largest stable step at the present mass scale [s]. Joints add no frequency: contact is an impulse, and the stiffness of fluid and
/// cohesion is taken implicitly (joint_step.hpp).
double stable_step(const StructureModel& model, const Geometry& geometry, const StructureState& state);

/// What the observer of sources sees; valid while the others are.
ObservedRock observed_rock(const StructureModel& model, const Geometry& geometry, const StructureState& state);

/// Half the trace length connected to the fluid [m].
double connected_half_length(const FractureNetwork& network);

}  // namespace fissura::structure
