// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/coupling/pressure_ramp.hpp"
#include "structure/joints/cohesive_law.hpp"
#include "structure/mesh/mesh.hpp"

namespace fissura::structure {

/// What never changes of a contact unit.
struct JointProperties {
  CohesiveLaw cohesive;             ///< with the strength the mesh can carry (tip_strength)
  double friction_coefficient = 0;  ///< tan(phi) [-]
  double friction_cohesion = 0;     ///< c of the friction law [Pa]
  double stored_aperture = 0;       ///< hydraulic aperture e_0 of a perforation [m]
  double residual_aperture = 0;     ///< hydraulic aperture of touching faces whose cement, if any, is broken [m]
  double dilation = 0;              ///< tan(psi) of touching faces that slide [-]
  double dilation_slip = 0;         ///< accumulated slip beyond which they dilate no more [m]
  FractureKind kind = FractureKind::open;
};

/// What changes of a contact unit in every step.
struct JointState {
  double opening = 0;              ///< signed gap e [m]
  double sliding = 0;              ///< signed slip, of plus against minus along (face_y, -face_x) / length [m]
  double sliding_at_rest = 0;      ///< what came before the slip that counts: the displacements hold it as well [m]
  double opening_rate = 0;         ///< [m/s]
  double greatest_separation = 0;  ///< q, history [m]
  double pressure = 0;             ///< fluid pressure applied in the last step [Pa]
  double held_normal = 0;          ///< T_n, tension positive, of the last step [Pa]
  double held_tangential = 0;      ///< T_s of the last step [Pa]
  double slip = 0;                 ///< accumulated |sliding| of closed faces [m]
  double dilation = 0;             ///< opening at which the faces touch [m]
  bool closed = true;
};

/// What a contact unit did in the present coupling interval in the steps in which it failed: touching faces
/// slid, or faces with cohesion moved farther apart than ever. Told on as a seismic source.
struct FaceMovement {
  double first = 0, last = 0;  ///< ends of the first and the last of those steps in the interval, (0, 1]
  double path = 0;             ///< of the jump of the displacement, over those steps [m]; 0: nothing failed
  double path_time = 0;        ///< sum of path times place in the interval [m]
  double opening = 0, sliding = 0;  ///< change of the jump along normal and tangent [m]
  double growth = 0;                ///< of slip or greatest separation [m]
  double peak_rate = 0;             ///< of the jump [m/s]
  bool cracked = false;             ///< cohesion wore off
};

/// All contact units of a mesh. Intact rock is held together until it is released (wet_release.hpp); open and natural fractures are
/// released from the start, natural ones filled with pore fluid at formation pressure.
struct Joints {
  std::vector<JointProperties> properties;  ///< per unit
  std::vector<JointState> state;            ///< per unit
  std::vector<std::uint8_t> released;       ///< per unit: the faces may separate and slide
  std::vector<PressureRamp> ramp;           ///< per unit, of the present coupling interval
  std::vector<FaceMovement> movement;       ///< per unit; empty if nobody asks for sources

  [[nodiscard]] bool broken(UnitIndex unit) const {
    return properties[unit].cohesive.broken(state[unit].greatest_separation);
  }
};

/// Properties of a unit of `mesh`: those of its line, with the strength that edges of this length can carry.
JointProperties joint_properties(const Mesh& mesh, UnitIndex unit, const Rock& rock);

/// Energy spent on the cohesion of all units so far, per unit thickness [J/m].
double cohesive_work(const Mesh& mesh, const Joints& joints);

/// The fracture vertex whose faces can separate that is nearest to `position`. @pre there is one
VertexIndex nearest_split_vertex(const Mesh& mesh, const Point& position);

bool has_natural_fractures(const Mesh& mesh);

/// Properties of every unit of `mesh` and the state at the start: every unit closed and at rest.
Joints make_joints(const Mesh& mesh, const Case& run_case);

}  // namespace fissura::structure
