// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "structure/mesh/size_field.hpp"

namespace fissura::structure {

/// Where interior points may lie: inside the domain and off the lines.
class MeshRegion {
 public:
  MeshRegion(const Domain& domain, const SizeField& field) : domain_(domain), field_(field) {}

  struct Sample {
    double size = 0;       ///< target edge length h [m]
    double clearance = 0;  ///< distance from the nearest line or side; negative outside the domain [m]
    double distance = 0;   ///< distance from the nearest line [m]
  };
  [[nodiscard]] Sample sample(Point point) const;
  [[nodiscard]] const SizeField& field() const { return field_; }
  [[nodiscard]] const Domain& domain() const { return domain_; }

 private:
  Domain domain_;
  const SizeField& field_;
};

}  // namespace fissura::structure
