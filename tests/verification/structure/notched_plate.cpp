// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "tests/verification/structure/pulled_plate.hpp"

/// A plate with a notch breaks along its ligament. Failure may start only in the elements that the straight
/// continuation of the notch reaches: a band left to itself follows the rows of the mesh. The triangles that
/// hold the last node of either end add about three quarters of an edge to the length broken.

using namespace fissura;
using namespace fissura::structure;

namespace {

constexpr double degree = 0.017453292519943295;

void keep_to_the_ligament(const Mesh& mesh, const Tiles& tiles, const RockFailure&, Damage& damage) {
  std::vector<ElementIndex> elsewhere;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element)
    if (!reaches(mesh, element, 0)) elsewhere.push_back(element);
  forbid_onset(tiles, elsewhere, damage);
}

}  // namespace

TEST_CASE("notched plate: the energy spent is the fracture energy for every mesh size and inclination",
          "[verification][structure]") {
  const double edge = GENERATE(0.04, 0.03, 0.02);
  const double inclination = GENERATE(0.0, 15.0, 30.0);
  const PulledPlate plate{{1, 1, edge, inclination * degree, 0.2}, 1.5e-4, keep_to_the_ligament};
  const Pulled result = pull(plate);
  CAPTURE(edge, inclination, result.work, result.peak, result.force_at_end);
  CHECK(result.spent == Approx(1).epsilon(0.05));
  CHECK(result.work == Approx(1).epsilon(0.05));  // the sides find the same as the book
  CHECK(result.force_at_end < 0.1);               // a corner of the last triangles holds on
}
