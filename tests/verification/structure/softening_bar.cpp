// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "structure/material/crack_band.hpp"
#include "tests/verification/structure/pulled_plate.hpp"

/// A bar that breaks along a row of weaker elements: the energy it takes is the fracture energy times the
/// cross-section, whatever the size and inclination of the mesh (Bazant & Oh 1983). The bar is shorter than
/// 2 E G_f / f_t^2, so that it softens without snapping back.

using namespace fissura;
using namespace fissura::structure;

namespace {

constexpr double degree = 0.017453292519943295;
constexpr double weakness = 0.9,
                 height_of_row = 0.011;  // [m]: off the middle, where no mesh has a row of nodes

void weaken_row(const Mesh& mesh, const Tiles& tiles, const RockFailure& law, Damage& damage) {
  std::vector<ElementDamage> records;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    if (!reaches(mesh, element, height_of_row)) continue;
    const std::array<double, 2> normal{0, 1};
    const auto& [a, b, c] = mesh.elements[element];
    const double band = crack_band_length({mesh.position[a], mesh.position[b], mesh.position[c]}, normal);
    DamageHistory history = undamaged_band(law.tension, normal, band);
    history.tensile_strength *= weakness;
    history.equivalent_strain *= weakness;
    records.push_back({element, history, {}});
  }
  damage = damage_from_records(tiles, records);
}

}  // namespace

TEST_CASE("softening bar: the energy spent is the fracture energy for every mesh size and inclination",
          "[verification][structure]") {
  const double edge = GENERATE(0.08, 0.06, 0.03);
  const double inclination = GENERATE(0.0, 15.0, 30.0);
  const PulledPlate bar{{1, 1, edge, inclination * degree, 0}, 1.5e-4, weaken_row};
  const Pulled result = pull(bar);
  CAPTURE(edge, inclination, result.work, result.peak);
  CHECK(result.spent == Approx(1).epsilon(0.02));
  CHECK(result.work == Approx(1).epsilon(0.02));  // the sides find the same as the book
  CHECK(result.peak == Approx(weakness).epsilon(0.05));
  CHECK(std::abs(result.force_at_end) < 0.002);  // of the strength; noise of waves
}
