// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "structure/mesh/mesh.hpp"

namespace fissura::structure {

/// A junction at which a fracture that joined a natural one may go on beyond it. It lasts until the first
/// segment there.
struct CrossingSeed {
  VertexIndex vertex = 0;             ///< the junction
  EdgeIndex edge = 0;                 ///< the last one of the fracture that arrived
  std::array<double, 2> direction{};  ///< in which it came, mean over its last edges: unit vector
};

}  // namespace fissura::structure
