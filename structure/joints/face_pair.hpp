// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "common/coupling/pressure_ramp.hpp"
#include "structure/joints/joint_state.hpp"
#include "structure/mesh/mesh.hpp"

/// The mechanics of one pair of faces in one explicit step. Internal to joint_step and junction_step.
namespace fissura::structure {

/// Below this gap faces under compression count as closed [m]; a smaller one lets contact flicker at the
/// rounding of the displacements.
inline constexpr double contact_tolerance = 1e-7;

struct Vector {
  double x = 0, y = 0;
};

inline Vector operator+(Vector a, Vector b) {
  return {a.x + b.x, a.y + b.y};
}
inline Vector operator-(Vector a, Vector b) {
  return {a.x - b.x, a.y - b.y};
}
inline Vector operator*(double s, Vector a) {
  return {s * a.x, s * a.y};
}
inline double dot(Vector a, Vector b) {
  return a.x * b.x + a.y * b.y;
}

/// The vector of node i in an array of x, y pairs, and back.
inline Vector at(std::span<const double> values, std::size_t i) {
  return {values[2 * i], values[2 * i + 1]};
}
inline void set(std::span<double> values, std::size_t i, Vector v) {
  values[2 * i] = v.x;
  values[2 * i + 1] = v.y;
}

/// Cundall's local damping of one node: force - lambda |force| sign(velocity), by component [N/m].
Vector damped(Vector force, Vector velocity, double lambda);

/// A contact unit during one step.
struct FacePair {
  NodeIndex minus = 0, plus = 0;
  double mass_minus = 0, mass_plus = 0;  ///< scaled [kg/m]
  Vector normal, tangent;                ///< from minus to plus; tangent = (n_y, -n_x)
  double length = 0;                     ///< of the face vector, on which every traction acts [m]
  double flatness = 1;                   ///< length over trace length, below 1 at a kink [-]
  double pressure = 0;                   ///< of the fluid, at the aperture of the step's begin [Pa]
  double rise = 0;                       ///< of touching faces in this step, by dilation [m]
  double normal_stiffness = 0;           ///< of fluid and unloading cohesion, taken implicitly [Pa/m]
  double tangential_stiffness = 0;       ///< of the cohesion, taken implicitly [Pa/m]
  bool stuck = false;                    ///< faces that touch do not slide in this step

  [[nodiscard]] double reduced_mass() const { return mass_minus * mass_plus / (mass_minus + mass_plus); }
};

/// The geometry of a unit, without masses and loads.
FacePair face_pair(const ContactUnit& unit);

/// The same with the masses of its nodes.
FacePair face_pair(const ContactUnit& unit, std::span<const double> mass, double mass_scale);

void set_masses(std::span<const double> mass, double mass_scale, FacePair& pair);

/// Beyond the opening at which the faces touch [m].
inline double gap(const JointState& state) {
  return state.opening - state.dilation;
}

inline bool touching(const JointState& state) {
  return gap(state) <= contact_tolerance;
}

/// By how much touching faces rise in a step, because they ride up each other's asperities (Patton 1966; Barton,
/// Bandis & Bakhtar 1985):
///   dilation = tan(psi) min(slip, dilation_slip)
/// one step behind the slip, and hardly faster (by a tenth) than tan(psi) times the present speed of sliding:
/// the relative velocity of the faces follows that of the sliding, so that the impulse that parts them is about
/// tan(psi) times the one that makes them slide. [m]
double dilation_rise(const JointProperties& properties, const JointState& state, double sliding_velocity,
                     double step);

/// Hydraulic aperture of a unit: opening, the stored aperture of a perforation, and the residual one by the
/// share of the cement that is lost [m].
double aperture(const JointProperties& properties, const JointState& state);

/// Sets pressure and stiffness of the fluid on the faces at `tau` of the coupling interval.
void load_by_fluid(const PressureRamp& ramp, double tau, const JointProperties& properties,
                   const JointState& state, FacePair& pair);

/// Sets the implicit stiffness of the cohesion and returns its traction at the step's begin.
CohesiveTraction pull_by_cohesion(const JointProperties& properties, const JointState& state, FacePair& pair);

/// Cohesion that touching faces offer against opening [Pa].
double holding_cohesion(const JointProperties& properties, const JointState& state);

/// Mohr-Coulomb: cohesion, what is left of the rock's own, and mu times the contact pressure (compression
/// positive) [Pa].
double greatest_shear_traction(const JointProperties& properties, const JointState& state,
                               double contact_pressure);

/// Traction that touching faces transmit to each other, the fluid pressure left out: effective, tension positive [Pa]; 0 of faces apart.
struct ContactTraction {
  double normal = 0;
  double shear = 0;  ///< on plus along the tangent; at most what friction and cohesion hold
};
ContactTraction contact_traction(const JointProperties& properties, const JointState& state, bool released);

/// Velocity of plus against minus along `direction` [m/s].
double relative_velocity(const FacePair& pair, Vector direction, std::span<const double> velocity);

/// Changes that velocity by `change`; the momentum of the pair stays.
void change_relative_velocity(const FacePair& pair, Vector direction, double change,
                              std::span<double> velocity);

/// Lets the implicit stiffnesses act on the opening and sliding of this step (backward Euler): no bound on
/// the step.
void resist_implicitly(const FacePair& pair, double step, std::span<double> velocity);

/// Lets the faces come no nearer than they touch at the end of the step. @param gap  now [m]
/// @returns the impulse that it takes [N s/m]
double forbid_overlap(const FacePair& pair, double gap, double step, std::span<double> velocity);

/// Friction of faces that strike each other: takes away sliding with an impulse of at most `greatest` [N s/m].
void rub(const FacePair& pair, double greatest, std::span<double> velocity);

/// Opening, sliding and pressure at the end of the step, from the displacements [m].
void observe(const FacePair& pair, const PressureRamp& ramp, double tau, const JointProperties& properties,
             std::span<const double> displacement, std::span<const double> velocity, JointState& state);

}  // namespace fissura::structure
