// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/reference/displacement_discontinuity.hpp"
#include "tests/reference/pressure_steps.hpp"
#include "tests/reference/sneddon.hpp"

using namespace fissura::reference;

TEST_CASE("displacement discontinuities: a uniform pressure opens the crack of Sneddon",
          "[reference][crack]") {
  const double modulus = 30e9, half_length = 10, pressure = 1e6;
  const auto error = [&](int cells) {
    std::vector<double> edges;
    for (int i = 0; i <= cells; ++i) edges.push_back(half_length * (2.0 * i / cells - 1));
    const Eigen::MatrixXd a = displacement_discontinuity::stiffness(edges, modulus);
    const Eigen::VectorXd w = a.inverse() * Eigen::VectorXd::Constant(cells, pressure);
    return w(cells / 2) / sneddon::aperture(pressure, half_length, modulus, 0) - 1;
  };
  // Constant cells make the crack a fixed part of a cell too long: an error of first order.
  CHECK(error(41) == Approx(0.5 / 41).epsilon(0.3));
  CHECK(error(41) / error(81) == Approx(81.0 / 41).epsilon(0.02));
}

TEST_CASE("pressure steps: the opening lost is the integral of the kernel", "[reference][crack]") {
  const auto kernel = [](double x, double eta) {
    const double c = std::sqrt(1 - x * x), d = std::sqrt(1 - eta * eta);
    return std::log(std::abs((c + d) / (c - d)));
  };
  for (const double x : {0.0, 0.3, 0.7, 0.95}) {
    for (const double b : {0.1, 0.5, 0.9}) {
      double sum = 0;
      const int cells = 200000;
      for (int i = 0; i < cells; ++i) sum += kernel(x, b + (1 - b) * (i + 0.5) / cells) * (1 - b) / cells;
      // The midpoint rule at the logarithmic peak and the square root at the tip.
      CHECK(pressure_steps::lost_opening(1 - x, 1 - b) == Approx(sum).epsilon(2e-5));
    }
  }
}

TEST_CASE("pressure steps: smooth where step and point meet, and exact for uniform pressure",
          "[reference][crack]") {
  for (const double gap : {1e-6, 1e-3, 0.2, 0.8}) {
    const double here = pressure_steps::lost_opening(gap, gap);
    CHECK(pressure_steps::lost_opening(gap, gap * (1 + 1e-9)) == Approx(here).epsilon(1e-6));
    CHECK(pressure_steps::lost_opening(gap, 1) == Approx(std::numbers::pi * pressure_steps::chord(gap)));
  }
  CHECK(pressure_steps::lost_volume(1) == Approx(std::numbers::pi / 4));
  CHECK(pressure_steps::lost_volume(0.99e-6 / 2) ==
        Approx(pressure_steps::lost_volume(1.01e-6 / 2)).epsilon(0.04));
}
