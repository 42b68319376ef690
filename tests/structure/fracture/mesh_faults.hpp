// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "structure/mesh/mesh.hpp"

namespace fissura::structure::fakes {

/// What is wrong with a mesh, found from the places of its nodes alone and without any code of the insertion;
/// empty if nothing is:
///  - every element is counter-clockwise and the elements fill the domain;
///  - the elements on both sides of an edge share its nodes, but for fracture edges, unless both ends are
///  tips;
///  - the rock around a fracture vertex has one node in every sector between its edges, every other place
///  one;
///  - contact units are the nodes left and right of every fracture edge, with face and length of its halves;
///  - the nodes on the sides, and the places without a node, are listed.
std::vector<std::string> mesh_faults(const Mesh& mesh, const Domain& domain);

}  // namespace fissura::structure::fakes
