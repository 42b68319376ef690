// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "common/case/case.hpp"
#include "structure/mesh/mesh.hpp"
#include "structure/mesh/mesh_change.hpp"
#include "structure/mesh/node_elements.hpp"

/// Masses, in-situ stress, external forces and constraints of a meshed body. Constant between changes of the
/// mesh. Everything is per unit thickness.
namespace fissura::structure {

/// A node whose displacement is given:  displacement * min(t / ramp, 1)  [m], at once if `ramp` is 0 [s].
struct PrescribedNode {
  NodeIndex node = 0;
  std::array<double, 2> displacement{};
  double ramp = 0;
};

/// In-situ state of an element at its centroid. Stored in single precision: it is streamed in every step.
struct InSituElement {
  float xx = 0, yy = 0, xy = 0, zz = 0;  ///< effective stress, tension positive [Pa]
  float pore_pressure = 0;               ///< Biot coefficient times pore pressure [Pa]
};

struct Body {
  std::vector<double> mass;  ///< lumped, of each node [kg/m]
  std::vector<std::array<double, 2>>
      inverse_mass;                        ///< x, y of each node [m/kg]; 0 where it cannot move freely
  std::vector<InSituElement> in_situ;      ///< of each element
  std::vector<double> external_force;      ///< interleaved x, y of each node [N/m]
  std::vector<PrescribedNode> prescribed;  ///< ascending in `node`
};

/// Nodes that belong to a contact unit, ascending. Their motion is integrated by the joints.
std::vector<NodeIndex> joint_nodes(const Mesh& mesh);

/// Builds the body of a case on a mesh.
///
/// External forces: body force; on every side the in-situ total traction, plus the traction `value` of a
/// traction side. A roller side is held in the normal direction, a fixed side in both. Where two sides meet,
/// fixed goes before displacement before roller before traction; of two displacement sides each gives its
/// normal component.
///
/// The in-situ state is in equilibrium at zero displacement: each force contains the rounding of the
/// single-precision stresses with the opposite sign, so that they cause no motion.
///
/// Throws SolverError naming the node if the in-situ state is out of equilibrium by more than rounding
/// anywhere but on fractures and held nodes, InputError if a fracture reaches a side with a prescribed
/// displacement.
Body build_body(const Mesh& mesh, const Case& settings);

/// After the mesh changed: what build_body would give, computed for the changed elements and nodes only; the
/// others keep their bits. `elements` has followed the change. A place without a node has no mass, inverse
/// mass and force. Throws like build_body.
void update_body(const Mesh& mesh, const NodeElements& elements, const Case& settings,
                 const MeshChange& change, Body& body);

}  // namespace fissura::structure
