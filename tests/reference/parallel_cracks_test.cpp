// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "tests/reference/parallel_cracks.hpp"

using fissura::reference::parallel_cracks::relative_middle_opening;

TEST_CASE("parallel cracks: far apart as two, close together as one", "[reference][crack]") {
  CHECK(relative_middle_opening(1e3, 51) == Approx(1).epsilon(1e-5));
  // What both open together is the opening of a single crack, shared; cells are a hundredth of a half-length.
  CHECK(relative_middle_opening(0.04, 201) == Approx(0.5).epsilon(0.02));
}

TEST_CASE("parallel cracks: the number of the case, converged", "[reference][crack]") {
  const double coarse = relative_middle_opening(1, 101), fine = relative_middle_opening(1, 201);
  // The error is of first order: the same step again, and half of it, and so on.
  CHECK(fine - coarse == Approx(4.0e-4).epsilon(0.1));
  CHECK(fine + (fine - coarse) == Approx(0.65857).epsilon(5e-5));
}
