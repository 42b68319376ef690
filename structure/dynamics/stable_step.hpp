// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "structure/dynamics/triangle.hpp"
#include "structure/material/elasticity.hpp"
#include "structure/mesh/mesh.hpp"

/// Stable step of central differences, dt <= 2 / omega_max.
///
/// If the mass of each node is shared out among its elements, in any way, the largest frequency of the mesh
/// is at most that of its stiffest element with its shares (Irons & Fried; the Rayleigh quotient of the mesh
/// is a mean of those of its elements). Sharing by area is safe but lets one small triangle among large ones
/// bind the step; sharing by stiffness is as safe and closer. Springs between nodes add at most their own
/// frequency, taken alone:
///   omega_max^2 <= max omega_element^2 + max omega_spring^2 .
namespace fissura::structure {

/// Largest frequency squared of a free triangle with the given masses at its corners [kg/m], all modes
/// [1/s2]:
///   omega^2 = max eigenvalue of  C (A sum of B_i B_i^T / m_i) ,  B_i the strain of corner i
double element_frequency_squared(const Triangle& shape, const Elasticity& moduli,
                                 const std::array<double, 3>& corner_mass);

/// The element that binds the step.
struct StiffestElement {
  double frequency_squared = 0;  ///< bound of the mesh [1/s2]
  ElementIndex element = 0;
  Point position{};  ///< its centroid [m]
};

/// Bound of the frequencies of the mesh with lumped masses; density [kg/m3]. The shares start in proportion
/// to the stiffness and are improved a few times. Throws SolverError naming the place of an element without
/// positive area.
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
