// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "structure/joints/cohesive_law.hpp"

using namespace fissura::structure;

namespace {

const CohesiveLaw shale{1e6, 50};

}  // namespace

TEST_CASE("pulling two faces apart spends the fracture energy", "[structure][joints]") {
  constexpr int steps = 20000;
  const double end = 1.1 * shale.critical_opening();
  double work = 0, q = 0;
  for (int k = 0; k < steps; ++k) {
    const double w = end * (k + 0.5) / steps;
    q = w;
    work += cohesion(shale, w, 0, q).normal * end / steps;
  }
  // The midpoint rule is exact for the linear law up to the one cell that holds its kink.
  CHECK(work == Approx(50).epsilon(1e-6));
  CHECK(shale.critical_opening() == Approx(1e-4).epsilon(1e-14));
  CHECK(shale.spent_energy(1) == Approx(50).epsilon(1e-14));
}

TEST_CASE("sliding and opening share one softening", "[structure][joints]") {
  const double q = 5e-5;
  const CohesiveTraction mixed = cohesion(shale, 3e-5, 4e-5, q);
  CHECK(mixed.normal / mixed.tangential == Approx(3.0 / 4.0).epsilon(1e-12));
  CHECK(std::hypot(mixed.normal, mixed.tangential) == Approx(shale.envelope(q)).epsilon(1e-12));
}

TEST_CASE("unloading goes back to the origin and reloading up the same way", "[structure][joints]") {
  const double q = 4e-5;
  CHECK(cohesion(shale, q, 0, q).normal == Approx(0.6e6).epsilon(1e-12));
  CHECK(cohesion(shale, q / 2, 0, q).normal == Approx(0.3e6).epsilon(1e-12));
  CHECK(cohesion(shale, 0, 0, q).normal == 0);
}

TEST_CASE("faces that have not moved hold with the whole strength, broken ones with none", "[structure][joints]") {
  CHECK(cohesion(shale, 0, 0, 0).normal == 1e6);
  CHECK(cohesion(shale, 1e-3, 0, 1e-3).normal == 0);
  CHECK(shale.broken(1e-4));
  CHECK_FALSE(shale.broken(0.99e-4));
  CHECK(CohesiveLaw{}.broken(0));
  CHECK(cohesion(CohesiveLaw{}, 1e-5, 1e-5, 1e-4).normal == 0);
}
