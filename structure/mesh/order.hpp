// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "structure/mesh/mesh.hpp"

namespace fissura::structure {

/// Puts the elements into the order in which a Hilbert curve visits their centroids, and numbers the nodes by
/// the first element that touches them, so that neighbours in space are neighbours in memory. Units and
/// vertices follow; their own order stays.
void order(Mesh& mesh);

}  // namespace fissura::structure
