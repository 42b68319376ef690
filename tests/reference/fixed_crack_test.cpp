// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/fixed_crack.hpp"

#include <catch2/catch.hpp>

using namespace fissura::reference;

TEST_CASE("fixed crack: published inlet of the monolithic run with 41 cells", "[reference][fixed_crack]") {
  const auto rows = fixed_crack::solve(fixed_crack::case_parameters(), 41, 0.01, fixed_crack::case_times());
  const double apertures[] = {0.59176, 0.64499, 0.75394, 0.88146, 1.14164};
  const double pressures[] = {0.40427, 0.42762, 0.44900, 0.45682, 0.50542};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    // The published run takes half the step; its error is of first order.
    CHECK(rows[i].aperture * 1e3 == Approx(apertures[i]).epsilon(5e-4));
    CHECK(rows[i].pressure * 1e-6 == Approx(pressures[i]).epsilon(5e-4));
  }
}

TEST_CASE("fixed crack: the limit of fine cells does not depend on where it is taken from",
          "[reference][fixed_crack]") {
  const auto parameters = fixed_crack::case_parameters();
  const std::vector<double> times{1, 5};
  const auto a = fixed_crack::extrapolate(parameters, 21, 0.1, times);
  const auto b = fixed_crack::extrapolate(parameters, 41, 0.1, times);
  for (std::size_t i = 0; i < times.size(); ++i) {
    // Terms of second order in the cell length, largest soon after the start.
    CHECK(a[i].aperture == Approx(b[i].aperture).epsilon(3e-3));
    CHECK(a[i].pressure == Approx(b[i].pressure).epsilon(3e-3));
  }
}
