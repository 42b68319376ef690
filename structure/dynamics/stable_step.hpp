// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "structure/dynamics/triangle.hpp"
#include "structure/material/elasticity.hpp"
#include "structure/mesh/mesh.hpp"

/// Stable step of central differences, dt <= 2 / omega_max. The largest frequency of the mesh is at most that
/// of its stiffest element (Irons & Fried), and springs between nodes add at most their own, taken alone:
///   omega_max^2 <= max omega_element^2 + max omega_spring^2 .
namespace fissura::structure {

/// Largest frequency squared of a free triangle with lumped mass [1/s2]; density [kg/m3].
///   omega^2 = (3 / density) max eigenvalue of C (B B^T)      exact, all modes
double element_frequency_squared(const Triangle& shape, const Elasticity& moduli, double density);

/// The element that binds the step.
struct StiffestElement {
  double frequency_squared = 0;  ///< [1/s2]
  ElementIndex element = 0;
  Point position{};  ///< its centroid [m]
};

/// Throws SolverError naming the place of an element without positive area.
StiffestElement stiffest_element(const Mesh& mesh, const Elasticity& moduli, double density);

/// Frequency squared of two free masses [kg/m] joined by a spring [N/m per m]:  k (1 / m_a + 1 / m_b) [1/s2].
/// Valid for several springs at once as the greatest of them if no node has two; springs at one node are
/// added first.
double pair_frequency_squared(double stiffness, double mass_a, double mass_b);

/// Conditions that set the step besides the frequencies.
struct StepConditions {
  double safety_factor = 0;  ///< < 1 [-]
  double mass_scale = 1;     ///< [-]
  double damping = 0;        ///< local damping [-]; raises the force on a node by up to this fraction
};

/// safety_factor 2 sqrt(mass_scale) / sqrt((element^2 + spring^2)(1 + damping))  [s]; the frequencies squared
/// [1/s2] are those of the unscaled masses, the second that of the contact, cohesion and fluid springs, 0
/// without any.
double stable_step(double element_frequency_squared, double spring_frequency_squared,
                   const StepConditions& conditions);

}  // namespace fissura::structure
