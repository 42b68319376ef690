// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "structure/dynamics/stable_step.hpp"
#include "structure/mesh/mesh_change.hpp"
#include "structure/mesh/node_elements.hpp"

/// The bound of stable_step.hpp element by element, so that it can follow a change of the mesh: with the mass
/// of each node shared out among its elements, each element's own frequency. Any shares that add up to one at
/// each node bound the mesh, so new shares at the changed nodes leave the rest as it is.
namespace fissura::structure {

struct FrequencyBound {
  std::vector<std::array<double, 3>> share;  ///< of the mass of each corner that goes to each element [-]
  std::vector<double> squared;               ///< frequency squared of each element with its shares [1/s2]
};

/// Shares in proportion to the stiffness, improved a few times; the best of these. Density [kg/m3]. Throws
/// SolverError naming the place of an element without positive area.
FrequencyBound bound_frequencies(const Mesh& mesh, const Elasticity& moduli, double density);

/// After the mesh changed: new shares at its changed nodes only. `elements` has followed the change. Throws
/// like bound_frequencies.
void update_frequencies(const Mesh& mesh, const NodeElements& elements, const Elasticity& moduli,
                        double density, const MeshChange& change, FrequencyBound& bound);

/// The element that binds the mesh; the first of equals.
StiffestElement stiffest_element(const Mesh& mesh, const FrequencyBound& bound);

}  // namespace fissura::structure
