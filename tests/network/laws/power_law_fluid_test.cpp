// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/laws/power_law_fluid.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace fissura::network;

namespace {

struct Benchmark {
  PowerLaw fluid;
  double aperture, velocity, viscosity, gradient;
};

const Benchmark benchmarks[] = {
    {{1, 0.5}, 5e-3, 0.1, 0.1054093, 5059.644},       {{0.5, 0.6}, 1e-3, 0.1, 4.365154e-2, 5.238185e4},
    {{0.5, 0.6}, 2e-3, 0.5, 3.025684e-2, 4.538526e4}, {{2, 0.4}, 1e-3, 0.1, 5.064957e-2, 6.077948e4},
    {{2, 0.4}, 2e-3, 0.5, 2.922885e-2, 4.384328e4},
};

// The published figures carry seven digits.
constexpr double digits = 5e-7;

/// Picard iteration of a segment with the secant viscosity; `given_flow` or given gradient.
double viscosity_after(const PowerLaw& fluid, double aperture, double velocity, double gradient,
                       bool given_flow, int passes) {
  double v = given_flow ? velocity : 0, g = given_flow ? 0 : gradient, viscosity = 0;
  for (int pass = 0; pass < passes; ++pass) {
    viscosity = secant_viscosity(fluid, aperture, g, v);
    if (given_flow)
      g = 12 * viscosity * v / (aperture * aperture);
    else
      v = aperture * aperture * g / (12 * viscosity);
  }
  return viscosity;
}

}  // namespace

TEST_CASE("power law: equivalent viscosity and gradient of the published flows", "[network][laws]") {
  for (const Benchmark& b : benchmarks) {
    CAPTURE(b.fluid.power_index, b.aperture);
    CHECK(viscosity_from_velocity(b.fluid, b.aperture, b.velocity) == Approx(b.viscosity).epsilon(digits));
    CHECK(gradient_from_velocity(b.fluid, b.aperture, b.velocity) == Approx(b.gradient).epsilon(digits));
  }
}

TEST_CASE("power law: viscosity from the gradient and from the velocity agree", "[network][laws]") {
  for (const Benchmark& b : benchmarks) {
    const double gradient = gradient_from_velocity(b.fluid, b.aperture, b.velocity);
    const double viscosity = viscosity_from_gradient(b.fluid, b.aperture, gradient);
    CHECK(viscosity == Approx(viscosity_from_velocity(b.fluid, b.aperture, b.velocity)).epsilon(1e-12));
    CHECK(b.aperture * b.aperture * gradient / (12 * viscosity) == Approx(b.velocity).epsilon(1e-12));
  }
}

TEST_CASE("power law: n = 1 is Newtonian whatever the flow", "[network][laws]") {
  const PowerLaw water{1.67e-3, 1};
  CHECK(viscosity_from_velocity(water, 1e-3, 0) == 1.67e-3);
  CHECK(viscosity_from_gradient(water, 1e-3, 0) == 1.67e-3);
  CHECK(secant_viscosity(water, 1e-3, 0, 0) == 1.67e-3);
}

TEST_CASE("power law: a fluid at rest has the viscosity of the gradient floor", "[network][laws]") {
  for (const double n : {0.3, 0.5, 1.3}) {
    const PowerLaw fluid{0.5, n};
    CHECK(secant_viscosity(fluid, 1e-3, 0, 0) ==
          Approx(viscosity_from_gradient(fluid, 1e-3, gradient_floor)).epsilon(1e-14));
  }
}

TEST_CASE(
    "power law: the secant viscosity contracts by |1 - n| / (1 + n) for given flow and for given gradient",
    "[network][laws]") {
  for (const double n : {0.3, 0.5, 0.8, 1.4}) {
    const PowerLaw fluid{0.5, n};
    const double velocity = 0.5, aperture = 1e-3;
    const double gradient = gradient_from_velocity(fluid, aperture, velocity);
    const double exact = viscosity_from_velocity(fluid, aperture, velocity);
    for (const bool given_flow : {true, false}) {
      CAPTURE(n, given_flow);
      const double error_5 =
          std::log(viscosity_after(fluid, aperture, velocity, gradient, given_flow, 5) / exact);
      const double error_6 =
          std::log(viscosity_after(fluid, aperture, velocity, gradient, given_flow, 6) / exact);
      // The floor of 10 Pa/m under gradients of 1e4 Pa/m bends the line by a few parts in a million.
      CHECK(std::abs(error_6) <= std::abs(error_5) * std::abs(1 - n) / (1 + n) * 1.001 + 1e-5);
    }
  }
}
