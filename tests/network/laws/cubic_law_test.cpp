// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/laws/cubic_law.hpp"

#include <catch2/catch.hpp>

using namespace fissura::network;

TEST_CASE("cubic law: permeability of parallel plates is e^2/12", "[network][laws]") {
  CHECK(permeability(1.2e-3) == Approx(1.2e-7).epsilon(1e-15));
}

TEST_CASE("cubic law: a metre of 1 mm fracture passes 4.99e-8 m2/s of 1.67 mPa s fluid per pascal",
          "[network][laws]") {
  CHECK(transmissibility(1e-3, 1.67e-3, 1) == Approx(4.9900e-8).epsilon(1e-5));
}

TEST_CASE("cubic law: a closed tip stays connected through the mean aperture of its segment",
          "[network][laws]") {
  CHECK(segment_aperture(1e-3, 0, 1e-5) == Approx(0.505e-3).epsilon(1e-15));
  CHECK(segment_aperture(0, 0, 1e-5) == 1e-5);
}
