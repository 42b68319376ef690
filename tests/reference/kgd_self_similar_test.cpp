// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/kgd_self_similar.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/reference/kgd_dontsov.hpp"

using namespace fissura::reference;

TEST_CASE("self-similar KGD: a Newtonian fluid without toughness gives the M vertex",
          "[reference][self_similar]") {
  const auto solution = kgd_self_similar::solve(1, 0.1, 80);
  REQUIRE(solution.converged);
  // The coefficients of the literature come from expansions of first order.
  CHECK(solution.gamma == Approx(0.6159).epsilon(2e-3));
  CHECK(solution.inlet_aperture == Approx(1.1265).epsilon(2e-3));
  CHECK(solution.inlet_pressure == Approx(0.5469).epsilon(5e-3));
}

TEST_CASE("self-similar KGD: n = 0.5 gives the published power-law numbers", "[reference][self_similar]") {
  const auto solution = kgd_self_similar::solve(0.5, 0.1, 80);
  REQUIRE(solution.converged);
  CHECK(solution.gamma == Approx(0.6425).epsilon(1e-3));
  CHECK(solution.inlet_aperture == Approx(1.1396).epsilon(1.5e-3));
  CHECK(solution.inlet_pressure == Approx(0.5834).epsilon(1e-3));
}

TEST_CASE("self-similar KGD: large toughness gives the K vertex", "[reference][self_similar]") {
  const auto solution = kgd_self_similar::solve(1, 20, 40);
  REQUIRE(solution.converged);
  CHECK(solution.gamma == Approx(0.9324 * std::pow(20, -2.0 / 3)).epsilon(5e-4));
  CHECK(solution.inlet_aperture == Approx(0.6828 * std::pow(20, 2.0 / 3)).epsilon(5e-4));
}

TEST_CASE("self-similar KGD: converges with its points", "[reference][self_similar]") {
  const auto coarse = kgd_self_similar::solve(0.5, 0.58, 40), middle = kgd_self_similar::solve(0.5, 0.58, 80),
             fine = kgd_self_similar::solve(0.5, 0.58, 160);
  const auto ratio = [](double a, double b, double c) { return (a - b) / (b - c); };
  // Second order: four; the kink of the aperture at the inlet and the tip leave something of a lower one.
  CHECK(ratio(coarse.gamma, middle.gamma, fine.gamma) > 2.5);
  CHECK(ratio(coarse.inlet_aperture, middle.inlet_aperture, fine.inlet_aperture) > 2.5);
  CHECK(middle.gamma == Approx(fine.gamma).epsilon(3e-4));
}

TEST_CASE("Dontsov's approximation against the numerical solution", "[reference][self_similar][kgd]") {
  struct Bound {
    double toughness, length, aperture, pressure;
  };
  // What the approximation is off by (columns in per cent of README.md), with a margin.
  for (const auto& bound : {Bound{0.284, 2e-3, 2e-3, 2e-3}, Bound{0.789, 3e-3, 3e-3, 2e-3},
                            Bound{2, 7e-3, 9e-3, 1e-2}, Bound{8.974, 5e-4, 5e-4, 5e-4}}) {
    const auto numerical = kgd_self_similar::solve(1, bound.toughness, 120);
    REQUIRE(numerical.converged);
    const ScaledParameters p{0.02, 3e10, bound.toughness * std::pow(0.02 * 1e-3 * 2.7e31, 0.25), 0, 1e-3};
    const auto unit = kgd_self_similar::scales(1, p.viscosity / 12, p.rate, p.modulus, p.toughness, 10);
    CHECK(unit.toughness == Approx(bound.toughness));
    const KgdState state = kgd_dontsov::state(p, 10);
    CHECK(state.half_length == Approx(numerical.gamma * unit.length).epsilon(bound.length));
    CHECK(state.inlet_aperture == Approx(numerical.inlet_aperture * unit.aperture).epsilon(bound.aperture));
    CHECK(state.inlet_net_pressure ==
          Approx(numerical.inlet_pressure * unit.pressure).epsilon(bound.pressure));
  }
}
