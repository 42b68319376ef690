// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/mesh_region.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::structure {

MeshRegion::Sample MeshRegion::sample(Point point) const {
  const SizeField::Sample field = field_.sample(point);
  const double to_side =
      std::min(domain_.width / 2 - std::abs(point[0]), domain_.height / 2 - std::abs(point[1]));
  return {field.size, std::min(field.distance, to_side), field.distance};
}

}  // namespace fissura::structure
