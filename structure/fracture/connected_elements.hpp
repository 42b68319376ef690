// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/mesh/mesh.hpp"
#include "structure/mesh/node_elements.hpp"

namespace fissura::structure {

/// The elements around `centre` [m] that can be reached from `start` through shared nodes without leaving the circle of this radius [m]:
/// the two sides of a fracture are connected around its tip only. An element belongs to the circle if a corner lies in it or it holds
/// the centre. Ascending.
std::vector<ElementIndex> connected_elements(const Mesh& mesh, const NodeElements& node_elements, NodeIndex start,
                                             const Point& centre, double radius);

}  // namespace fissura::structure
