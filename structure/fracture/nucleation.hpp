// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/fracture/failure_path.hpp"

namespace fissura::structure {

/// A fracture to come where there was none.
struct Nucleus {
  std::vector<Point> line;  ///< at least three points, one tip_size apart [m]
  NodeIndex node = 0;       ///< near its middle
};

/// Clusters of failed elements, connected through nodes, that are farther than three tip_size from every
/// fracture and at least Growth::failure_length long across their greatest principal stress. Each gives a
/// line through its middle that follows the march both ways as far as the rock has failed; it keeps away from
/// the sides of the domain. Larger clusters first.
std::vector<Nucleus> nuclei(const RockNow& rock, const FailureMap& map);

}  // namespace fissura::structure
