// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/sneddon.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace fissura::reference;

namespace {

constexpr double modulus = 32e9 / 0.96;

}  // namespace

TEST_CASE("Sneddon: opening, volume and stress intensity of a crack of 10 m under 1 MPa",
          "[reference][sneddon]") {
  CHECK(sneddon::aperture(1e6, 10, modulus, 0) == Approx(1.2e-3).epsilon(1e-12));
  CHECK(sneddon::aperture(1e6, 10, modulus, 5) == Approx(1.039230e-3).epsilon(1e-6));
  CHECK(sneddon::volume(1e6, 10, modulus) == Approx(1.884956e-2).epsilon(1e-6));
  CHECK(sneddon::stress_intensity(1e6, 10) == Approx(5.604991e6).epsilon(1e-6));
}

TEST_CASE("Sneddon: the volume is the integral of the opening", "[reference][sneddon]") {
  double sum = 0;
  const int cells = 4000;
  for (int i = 0; i < cells; ++i)
    sum += sneddon::aperture(2e6, 3, modulus, -3 + 6 * (i + 0.5) / cells) * 6 / cells;
  // The midpoint rule loses order at the square-root ends.
  CHECK(sum == Approx(sneddon::volume(2e6, 3, modulus)).epsilon(1e-5));
}

TEST_CASE("Sneddon: a crack at arrest holds its volume and stands at its toughness", "[reference][sneddon]") {
  const double toughness = std::sqrt(modulus * 50);
  const auto arrest = sneddon::arrest(5e-3, toughness, modulus);
  CHECK(sneddon::volume(arrest.net_pressure, arrest.half_length, modulus) == Approx(5e-3).epsilon(1e-12));
  CHECK(sneddon::stress_intensity(arrest.net_pressure, arrest.half_length) ==
        Approx(toughness).epsilon(1e-12));
}
