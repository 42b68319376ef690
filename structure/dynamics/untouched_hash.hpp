// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "structure/dynamics/body.hpp"
#include "structure/mesh/mesh.hpp"

namespace fissura::structure {

/// What is about to change, or has changed; both ascending.
struct Touched {
  std::vector<ElementIndex> elements;
  std::vector<NodeIndex> nodes;
};

/// Digest, as 32 hexadecimal digits, of everything that is neither touched nor unused: for each element its
/// corners and in-situ state, for each node its index, position, displacement [m] and velocity [m/s]
/// (interleaved x, y). A sum over the items of two independent mixes of their bits: the order of the elements
/// plays no part, so an element may move to another place in the list. Equal before and after a change of the
/// mesh if and only if, short of a chance of about 2^-128, all the rest kept its bits.
std::string untouched_hash(const Mesh& mesh, const Body& body, const std::vector<double>& displacement,
                           const std::vector<double>& velocity, const Touched& touched);

}  // namespace fissura::structure
