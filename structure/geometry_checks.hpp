// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/dynamics/body.hpp"
#include "structure/dynamics/frequency_bound.hpp"
#include "structure/mesh/mesh.hpp"

/// Of a geometry that was read: that its parts fit together, so that nothing built on them reaches beyond
/// them. All throw Error(checkpoint_unusable).
namespace fissura::structure {

/// Every index of the mesh points at something, and fractures know their own edges and units and no others.
void require_whole(const Mesh& mesh);

void require_of_mesh(const Body& body, const Mesh& mesh);
void require_of_mesh(const FrequencyBound& bound, const Mesh& mesh);

/// Every element stands in one tile, once, and no tile is larger than tiles become.
void require_all_elements(const std::vector<std::vector<ElementIndex>>& tiles, const Mesh& mesh);

}  // namespace fissura::structure
