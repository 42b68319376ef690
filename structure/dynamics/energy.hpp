// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/dynamics/body.hpp"
#include "structure/dynamics/damage_state.hpp"
#include "structure/material/rankine_damage.hpp"
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

/// By how much the damage lowers the energy stored,  sum of A D s+ : C^-1 : s / 2.
double released_energy(const Mesh& mesh, const Body& body, const Elasticity& moduli,
                       const std::vector<double>& displacement, const std::vector<ElementDamage>& records);

/// Spent on damage,  sum of A times dissipated_energy().
double damage_dissipation(const Mesh& mesh, const RankineDamage& law,
                          const std::vector<ElementDamage>& records);

}  // namespace fissura::structure
