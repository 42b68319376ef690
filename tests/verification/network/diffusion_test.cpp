// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/network/flow_setup.hpp"

using namespace fissura;
using namespace fissura::network;
using namespace fissura::network::test;

namespace {

constexpr double aperture = 1e-3, pi = 3.14159265358979323846;
constexpr double diffusivity = aperture * aperture * 2e9 / (12 * 1.67e-3);

/// Pressure at the closed end of a rigid fracture of 100 m, over the step at its inlet (Carslaw and Jaeger
/// 1959, 3.3).
double exact_at_closed_end(double time) {
  constexpr double length = 100;
  double sum = 0;
  for (int k = 0; k < 200; ++k) {
    const double root = (2 * k + 1) * pi / (2 * length);
    sum += (k % 2 == 0 ? 1 : -1) / (2 * k + 1.0) * std::exp(-diffusivity * root * root * time);
  }
  return 1 - 4 / pi * sum;
}

FlowSetup rigid_fracture(const Schedule& schedule, double h) {
  Model model = water_model();
  model.schedule = schedule;
  model.well_index = 1e3;
  FlowSetup setup(model, straight_fracture(static_cast<std::size_t>(std::lround(100 / h)) + 1, h, {0}));
  setup.set_rigid(aperture);
  return setup;
}

double computed_at_closed_end(double time, int steps, double h) {
  FlowSetup setup = rigid_fracture(constant_pressure(1e6), h);
  for (int k = 0; k < steps; ++k) setup.advance(time / steps);
  return setup.state.pressure.back() / 1e6;
}

}  // namespace

TEST_CASE("diffusion: pressure at the closed end of a rigid fracture after a step at its inlet",
          "[network][verification]") {
  const struct {
    double time, ratio;
  } published[] = {{0.01, 0.050403}, {0.02, 0.226967}, {0.05, 0.628308}, {0.1, 0.891490}};
  for (const auto& [time, ratio] : published) {
    CAPTURE(time);
    CHECK(exact_at_closed_end(time) == Approx(ratio).margin(1e-6));
    // First order in the step, 2000 of them.
    CHECK(computed_at_closed_end(time, 2000, 1) == Approx(ratio).margin(5e-4));
  }
}

TEST_CASE("diffusion: a step into a long fracture spreads as the complementary error function",
          "[network][verification]") {
  FlowSetup setup = rigid_fracture(constant_pressure(1e6), 0.5);
  for (int k = 0; k < 1000; ++k) setup.advance(1e-6);
  for (const double x : {5.0, 10.0, 20.0}) {
    const double exact = std::erfc(x / (2 * std::sqrt(diffusivity * 1e-3)));
    CHECK(setup.state.pressure[static_cast<std::size_t>(std::lround(2 * x))] / 1e6 ==
          Approx(exact).margin(1e-3));
  }
}

TEST_CASE("diffusion: inlet pressure under a constant rate grows with the square root of time",
          "[network][verification]") {
  FlowSetup setup = rigid_fracture(constant_rate(1e-3), 0.25);
  for (int k = 0; k < 1000; ++k) setup.advance(1e-6);
  CHECK(setup.state.pressure.front() == Approx(0.225901e6).epsilon(5e-3));
}

TEST_CASE("diffusion: backward Euler is of first order", "[network][verification]") {
  // A fine space grid and the exact solution of the equation: what is left is the error in time.
  const double exact = exact_at_closed_end(0.05);
  const double coarse = computed_at_closed_end(0.05, 50, 0.5) - exact;
  const double fine = computed_at_closed_end(0.05, 100, 0.5) - exact;
  CHECK(std::log2(coarse / fine) == Approx(1).margin(0.05));
}
