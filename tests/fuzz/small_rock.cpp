// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/small_rock.hpp"

namespace fissura::fuzz {

Case small_rock_case() {
  Case settings;
  settings.rock = {2500, 32e9, 0.2, 1e6, 50, 1};
  const Boundary free{BoundaryKind::traction, {0, 0}, 0};
  settings.boundary = {free, free, free, free};
  settings.boundary.west.kind = BoundaryKind::roller;
  settings.in_situ.stress = {-12e6, -13e6, -2e6, -20e6};
  settings.in_situ.pore_pressure = 30e6;
  settings.domain = {10, 10, 1};
  settings.mesh = {1, 2, 1, 0.3, 1, 1, 2, 0.4, {}, {}};
  settings.fractures.push_back({"slit", FractureKind::open, {{-1, 0}, {1, 0}}, 0, 0, 0.5, 0});
  settings.fractures.push_back({"joint", FractureKind::natural, {{3, -1}, {3, 1}}, 0, 0, 0.6, 1e5});
  return settings;
}

structure::StructureModel small_rock_model() {
  const Case settings = small_rock_case();
  return {settings, structure::elasticity(settings.rock), 1};
}

}  // namespace fissura::fuzz
