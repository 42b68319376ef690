// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/dynamics/body.hpp"
#include "structure/fracture/dislocation_field.hpp"
#include "structure/material/elasticity.hpp"
#include "structure/mesh/mesh.hpp"

namespace fissura::structure {

/// A place that a fracture is about to reach.
struct MeetingPlace {
  Point centre{};       ///< [m]
  VertexIndex tip = 0;  ///< of that fracture, or any other of its vertices
  double h = 0;         ///< element size there [m]
};

/// How far the faces of the fracture that `vertex` belongs to have moved: of every edge that can be reached
/// from there along edges that are not natural fractures. Zero at unsplit ends and where the rock still
/// holds.
std::vector<DisplacementJump> jumps_of_fracture(const Mesh& mesh, const std::vector<double>& displacement,
                                                VertexIndex vertex);

/// Total stress that would act at a place if the fracture about to reach it were closed, tension positive
/// [Pa]: in situ, other fractures, sides and all. In every element within 6 h of the place, but not within 2
/// h of the fracture, it is the stress of the element less that of the fracture's own opening and sliding in
/// an infinite plane (stress_of_jump); the value at the place is that of the plane through these, linear in x
/// and y, that fits best by area. Elements on both sides of a natural fracture count: it is taken to be
/// closed.
///
/// A fit of the fields of a tip cannot give it: their constant part is -p across a fracture under the
/// pressure p, whatever acts far away, and what does act there enters through the stress intensity, which
/// depends on the length as well.
///
/// Damage is not regarded. Where hardly any element is left, the in-situ stress of the nearest one.
InPlane<double> local_stress(const Mesh& mesh, const Body& body, const Elasticity& moduli,
                             const std::vector<double>& displacement, const MeetingPlace& place);

}  // namespace fissura::structure
