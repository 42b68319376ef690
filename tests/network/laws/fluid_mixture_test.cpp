// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/laws/fluid_mixture.hpp"

#include <array>
#include <catch2/catch.hpp>

using namespace fissura::network;

TEST_CASE("mixture: fluids one behind the other add their pressure drops", "[network][laws]") {
  const std::array<double, 2> amounts{3, 1}, viscosities{1e-3, 0.1};
  CHECK(mixture_viscosity(amounts, viscosities) == Approx((3 * 1e-3 + 0.1) / 4).epsilon(1e-15));
}

TEST_CASE("mixture: under one pressure the volume changes add", "[network][laws]") {
  const std::array<double, 2> amounts{1, 1}, moduli{2e9, 1e8};
  CHECK(1 / mixture_bulk_modulus(amounts, moduli) == Approx(0.5 / 2e9 + 0.5 / 1e8).epsilon(1e-15));
}
