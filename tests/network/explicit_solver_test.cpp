// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/explicit/explicit_solver.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "tests/network/cell_setup.hpp"

using namespace fissura;
using namespace fissura::network::test;
using fissura::explicit_flow::ExplicitSolver;

namespace {

/// Open faces around a uniform pressure [Pa].
void set_rock(CellSetup& setup, double aperture, double compliance, double pressure) {
  std::ranges::fill(setup.interval.aperture, aperture);
  std::ranges::fill(setup.interval.compliance, compliance);
  std::ranges::fill(setup.interval.reference_pressure, pressure);
}

double greatest(const std::vector<double>& values) {
  return *std::ranges::max_element(values);
}

double least(const std::vector<double>& values) {
  return *std::ranges::min_element(values);
}

/// What a ledger misses, of its largest entry.
double missing(const FluidLedger& ledger) {
  const double largest = std::max({ledger.injected, ledger.in_place, ledger.in_fractures, ledger.leaked});
  return std::abs(ledger.residual()) / largest;
}

}  // namespace

TEST_CASE("explicit solver: within its bound pressures make no new extremes, whatever the interval",
          "[network][explicit]") {
  for (const double duration : {1e-4, 1e-2, 1.0}) {
    ExplicitSolver solver;
    CellSetup setup(solver, water(), chain(41, 0.5, {}));
    set_rock(setup, 3e-4, 1e-10, 0);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> pressure(1e6, 2e6);
    // Contents begin as apertures: faces that closed since leave fluid under pressure behind.
    for (double& reference : setup.interval.reference_pressure) reference = pressure(random);
    FlowAnswer answer = setup.advance(1e-9);
    double high = greatest(answer.pressure), low = least(answer.pressure);
    REQUIRE(high > 1.1 * low);
    for (int k = 0; k < 30; ++k) {
      answer = setup.advance(duration);
      // Pressures are found from contents to rounding.
      CHECK(greatest(answer.pressure) <= high * (1 + 1e-9));
      CHECK(least(answer.pressure) >= low * (1 - 1e-9));
      high = greatest(answer.pressure);
      low = least(answer.pressure);
    }
  }
}

TEST_CASE("explicit solver: sub-steps are a fixed share of the time that pressure takes from cell to cell",
          "[network][explicit]") {
  // l c / sum T of an inner cell: half the square of the spacing over the diffusivity.
  const double h = 0.5, aperture = 3e-4, compliance = 1e-10, modulus = 2e9;
  const double storage = compliance + aperture / modulus;
  const double diffusivity = aperture * aperture * aperture / (12 * 1.67e-3 * storage);
  const double bound = h * h / (2 * diffusivity);
  ExplicitSolver solver;
  CellSetup setup(solver, water(), chain(41, h, {}));
  set_rock(setup, aperture, compliance, 0);
  const FlowAnswer answer = setup.advance(1000 * bound);
  CHECK(answer.iterations == static_cast<int>(std::ceil(1000 / explicit_flow::stable_share)));
}

TEST_CASE("explicit solver: fluid is kept to rounding over ten thousand intervals of moving faces",
          "[network][explicit]") {
  FlowCase leaking = water();
  leaking.leak_off_coefficient = 1e-6;
  leaking.stages = {from_the_start(WellControl::rate, 1e-4)};
  ExplicitSolver solver;
  CellSetup setup(solver, leaking, chain(9, 0.5, {4}));
  set_rock(setup, 3e-4, 1e-10, 1e6);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> factor(0.9, 1.1);
  double worst = 0;
  FlowAnswer answer;
  for (int k = 0; k < 10000; ++k) {
    answer = setup.advance(1e-4);
    worst = std::max(worst, missing(answer.ledger));
    for (std::size_t i = 0; i < setup.interval.aperture.size(); ++i)
      setup.interval.aperture[i] = 3e-4 * factor(random);
  }
  // The contract allows 1e-10; ten thousand roundings of 1e-16 that all go one way.
  CHECK(worst < 1e-12);
  CHECK(answer.ledger.leaked > 0);
}

TEST_CASE("explicit solver: a well that draws takes no more than there is", "[network][explicit]") {
  FlowCase drawn = water();
  drawn.stages = {from_the_start(WellControl::rate, -1e-3)};
  ExplicitSolver solver;
  CellSetup setup(solver, drawn, chain(9, 0.5, {4}));
  set_rock(setup, 3e-4, 1e-10, 1e6);
  for (int k = 0; k < 20; ++k) {
    const FlowAnswer answer = setup.advance(0.1);
    CHECK(least(answer.pressure) >= 0);
    CHECK(least(setup.content()) >= 0);
    CHECK(missing(answer.ledger) < 1e-12);
  }
}

TEST_CASE("explicit solver: a piece of time as short as rounding ends", "[network][explicit]") {
  FlowCase staged = water();
  staged.stages = {from_the_start(WellControl::rate, 1e-4), from_the_start(WellControl::rate, 2e-4)};
  staged.stages[1].begin = 0.3;
  ExplicitSolver solver;
  CellSetup setup(solver, staged, chain(9, 0.5, {4}));
  set_rock(setup, 3e-4, 1e-10, 1e6);
  setup.advance(0.1);
  setup.advance(0.2);
  REQUIRE(setup.interval.end != 0.3);
  CHECK(setup.advance(0.1).ledger.injected == Approx(10 * (0.3 * 1e-4 + 0.1 * 2e-4)).epsilon(1e-12));
}
