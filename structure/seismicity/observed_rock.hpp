// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "structure/dynamics/body.hpp"
#include "structure/dynamics/damage_state.hpp"
#include "structure/joints/joint_state.hpp"
#include "structure/material/elasticity.hpp"
#include "structure/mesh/mesh.hpp"

namespace fissura::structure {

/// What the observer of seismic sources looks at and does not keep.
struct ObservedRock {
  [[nodiscard]] double thickness() const { return run_case.domain.thickness; }

  const Mesh& mesh;
  const Body& body;
  const Tiles& tiles;
  const Elasticity& moduli;
  const Case& run_case;
  std::uint64_t geometry = 0;  ///< number of the mesh
  const std::vector<double>& displacement;
  const Damage& damage;
};

/// A coupling interval that the structure has gone through.
struct ObservedInterval {
  double begin = 0, end = 0;  ///< [s]
  std::uint64_t steps = 0;    ///< explicit steps of equal length
  double mass_scale = 1;      ///< [-]

  /// Time at a place in the interval, 0 to 1 [s].
  [[nodiscard]] double time(double place) const { return place < 1 ? begin + place * (end - begin) : end; }
  /// Begin of the step that ends at a place [s].
  [[nodiscard]] double begin_of_step(double place) const {
    return time(place - 1 / static_cast<double>(steps));
  }
};

}  // namespace fissura::structure
