// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/dynamics/body.hpp"
#include "structure/dynamics/damage_state.hpp"
#include "structure/material/mohr_circle.hpp"
#include "structure/mesh/mesh.hpp"

/// Fields of the elements for output, computed from displacements [m] (interleaved x, y per node).
namespace fissura::structure {

/// Effective stress of an element, tension positive [Pa].
using ElementStress = PlaneStrainStress;

/// Stress of one element as if it were elastic, in-situ part included.
ElementStress undamaged_stress(const Mesh& mesh, const Body& body, const Elasticity& moduli,
                               ElementIndex element, const std::vector<double>& displacement);

/// Effective stress of every element; those in `records` (see damage_records) carry  s - D s+  of the strain
/// less its plastic part.
std::vector<ElementStress> effective_stress(const Mesh& mesh, const Body& body, const Elasticity& moduli,
                                            const std::vector<double>& displacement,
                                            const std::vector<ElementDamage>& records);

/// In-plane principal stresses of every element.
std::vector<Principal> principal_stresses(const std::vector<ElementStress>& stress);

/// Damage of every element, 0 without a record.
std::vector<double> damage_field(const Mesh& mesh, const std::vector<ElementDamage>& records);

/// Size of the plastic strain of every element, sqrt(2/3 eps_p : eps_p) [-], 0 without a record.
std::vector<double> plastic_strain_field(const Mesh& mesh, const std::vector<ElementDamage>& records);

}  // namespace fissura::structure
