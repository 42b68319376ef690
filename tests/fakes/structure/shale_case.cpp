// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/structure/shale_case.hpp"

namespace fissura::structure::fakes {

Case shale_case() {
  Case settings;
  settings.rock = {2500, 32e9, 0.2, 1e6, 50, 1};
  const Boundary free{BoundaryKind::traction, {0, 0}, 0};
  settings.boundary = {free, free, free, free};
  return settings;
}

Case stressed_shale_case() {
  Case settings = shale_case();
  settings.in_situ.stress = {-12.065876e6, -12.934124e6, -2.462019e6, -20e6};
  settings.in_situ.pore_pressure = 30e6;
  return settings;
}

}  // namespace fissura::structure::fakes
