// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/dynamics/body.hpp"
#include "structure/dynamics/damage_state.hpp"
#include "structure/material/rock_failure.hpp"
#include "structure/mesh/mesh.hpp"

/// Energies per unit thickness [J/m], relative to the in-situ state. Sums run in the order of nodes or
/// elements. Without damping, joints and moving boundaries
///   kinetic + strain - released + dissipated + work against the in-situ stress - external work = constant .
/// Displacements [m] and velocities [m/s] are interleaved x, y per node.
namespace fissura::structure {

/// sum of mass_scale m v^2 / 2.
double kinetic_energy(const Body& body, const std::vector<double>& velocity, double mass_scale);

/// sum of A eps : C : eps / 2 of the undamaged rock.
double strain_energy(const Mesh& mesh, const Elasticity& moduli, const std::vector<double>& displacement);

/// sum of A (sigma_0 - alpha p) : eps.
double in_situ_work(const Mesh& mesh, const Body& body, const std::vector<double>& displacement);

/// sum of external force times displacement.
double external_work(const Body& body, const std::vector<double>& displacement);

/// By how much failure lowers the energy stored: damage by  sum of A D s+ : C^-1 : s / 2 , plastic strain by
/// that of the strain it takes away, in-situ stress included.
double released_energy(const Mesh& mesh, const Body& body, const Elasticity& moduli,
                       const std::vector<double>& displacement, const std::vector<ElementDamage>& records);

/// Spent on damage and plastic flow of the elements there are,  sum of A times dissipated_energy().
double failure_dissipation(const Mesh& mesh, const RockFailure& law,
                           const std::vector<ElementDamage>& records);

}  // namespace fissura::structure
