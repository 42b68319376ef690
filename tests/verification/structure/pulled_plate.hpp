// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "structure/dynamics/damage_state.hpp"
#include "structure/material/rock_failure.hpp"
#include "tests/fakes/structure/lattice_mesh.hpp"

namespace fissura::structure {

/// A plate of shale that softens linearly, pulled apart slowly by its north and south side.
struct PulledPlate {
  fakes::Lattice lattice;
  double stretch = 0;  ///< at the end [m]
  /// Prepares the failure of the plate before it is pulled.
  std::function<void(const Mesh& mesh, const Tiles& tiles, const RockFailure& law, Damage& damage)> prepare;
};

struct Pulled {
  double spent = 0;         ///< energy dissipated over G_f times the area of the ligament [-]
  double work = 0;          ///< work of the sides, less the elastic energy left, over the same [-]
  double peak = 0;          ///< greatest force over f_t times the area of the ligament [-]
  double force_at_end = 0;  ///< the same at the end [-]
};

Pulled pull(const PulledPlate& plate);

/// True if a triangle has a corner on the line y = `height` [m] or corners on both sides of it.
bool reaches(const Mesh& mesh, ElementIndex element, double height);

}  // namespace fissura::structure
