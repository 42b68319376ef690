// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "structure/mesh/mesh.hpp"

namespace fissura::structure::fakes {

/// What is wrong with a mesh, found from the places of its nodes alone and without any code of the insertion;
/// empty if nothing is:
///  - every element is counter-clockwise and the elements fill the domain;
///  - an edge with rock on one side only lies on a side of the domain or is a fracture edge, and every
///  fracture edge is one on both sides
///    or, next to a tip, on none;
///  - the rock around a fracture vertex has one node in every sector between its edges, all other places have
///  one node;
///  - contact units are those of the nodes left and right of every fracture edge, with the face and length of
///  the halves of those edges;
///  - the nodes on the sides, and the places without a node, are listed.
std::vector<std::string> mesh_faults(const Mesh& mesh, const Domain& domain);

}  // namespace fissura::structure::fakes
