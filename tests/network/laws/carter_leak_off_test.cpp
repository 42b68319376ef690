// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/laws/carter_leak_off.hpp"

#include <catch2/catch.hpp>

using namespace fissura::network;

namespace {

/// Midpoint rule over the part of the cell exposed at `time`.
double mean_of_faces(const CarterLaw& law, double t_a, double t_b, double time) {
  constexpr int points = 200000;
  double sum = 0;
  for (int k = 0; k < points; ++k) sum += face_leak_off(law, t_a + (k + 0.5) / points * (t_b - t_a), time);
  return 2 * sum / points;
}

}  // namespace

TEST_CASE(
    "Carter: one face with C_l = 1e-5 exposed from 100 s to 400 s loses 2.0e-4 m on top of what it lost "
    "before",
    "[network][laws]") {
  const CarterLaw law{1e-5, 0};
  CHECK(face_leak_off(law, 0, 400) - face_leak_off(law, 0, 100) == Approx(2.0e-4).epsilon(1e-14));
}

TEST_CASE("Carter: nothing is lost before exposure, the spurt at once after it", "[network][laws]") {
  const CarterLaw law{1e-5, 1e-4};
  CHECK(face_leak_off(law, 3, 3) == 0);
  CHECK(cell_leak_off(law, 3, 5, 2.9) == 0);
  CHECK(face_leak_off(law, 3, 3 + 1e-12) == Approx(1e-4).epsilon(1e-6));
}

TEST_CASE("Carter: a cell exposed at once loses twice what one face does", "[network][laws]") {
  const CarterLaw law{5e-5, 1e-4};
  CHECK(cell_leak_off(law, 2, 2, 11) == Approx(2 * face_leak_off(law, 2, 11)).epsilon(1e-14));
}

TEST_CASE("Carter: a swept cell loses the mean over its exposed part", "[network][laws]") {
  const CarterLaw law{5e-5, 1e-4};
  for (const double time : {1.3, 2.0, 2.5, 50.0}) {
    CAPTURE(time);
    // Midpoint rule next to the square root: error of order points^-1.5.
    CHECK(cell_leak_off(law, 1, 2, time) == Approx(mean_of_faces(law, 1, 2, time)).epsilon(1e-5));
  }
}

TEST_CASE("Carter: the swept cell keeps its digits when the sweep was short against its age",
          "[network][laws]") {
  const CarterLaw law{5e-5, 0};
  CHECK(cell_leak_off(law, 1, 1 + 1e-9, 1e4) == Approx(cell_leak_off(law, 1, 1, 1e4)).epsilon(1e-12));
}
