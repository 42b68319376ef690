// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/network/flow_setup.hpp"

using namespace fissura;
using namespace fissura::network;
using namespace fissura::network::test;

namespace {

constexpr double pi = 3.14159265358979323846, rate = 1e-3, width = 2e-3;

/// Length of a fracture of constant width under constant rate and Carter leak-off (Howard and Fast 1957).
double exact_length(const CarterLaw& law, double time) {
  const double storage = width + 2 * law.spurt_volume;
  const double b = 2 * law.coefficient * std::sqrt(pi * time) / storage;
  return rate * storage / (4 * pi * law.coefficient * law.coefficient) *
         (std::exp(b * b) * std::erfc(b) + 2 * b / std::sqrt(pi) - 1);
}

/// A dry natural fracture of constant width, flooded from one end; returns the wetted length.
double flooded_length(const CarterLaw& law, double h, double interval, double time) {
  Model model = water_model();
  model.leak_off = law;
  model.schedule = constant_rate(rate);
  const auto nodes = static_cast<std::size_t>(60 / h) + 1;
  FlowSetup setup(model, straight_fracture(nodes, h, {0}, SegmentKind::natural));
  setup.interval.aperture.front() = 1e-9;
  setup.advance(1e-9);
  setup.set_rigid(width);
  while (setup.state.time < time) setup.advance(std::min(interval, time - setup.state.time));
  double wet = 0;
  for (std::size_t i = 0; i < nodes; ++i) wet += setup.graph.lumped_length()[i] * setup.state.filled[i];
  return wet;
}

}  // namespace

TEST_CASE("Carter balance: the closed form gives the published lengths", "[network][verification]") {
  CHECK(exact_length({1e-6, 0}, 100) == Approx(49.34110).epsilon(1e-6));
  CHECK(exact_length({1e-5, 1e-4}, 100) == Approx(40.48248).epsilon(1e-6));
  CHECK(exact_length({5e-5, 0}, 100) == Approx(29.33476).epsilon(1e-6));
  CHECK(exact_length({5e-5, 1e-4}, 100) == Approx(27.74801).epsilon(1e-6));
}

TEST_CASE("Carter balance: a flooded fracture of constant width reaches the length of Howard and Fast",
          "[network][verification]") {
  for (const CarterLaw& law :
       {CarterLaw{1e-6, 0}, CarterLaw{1e-5, 1e-4}, CarterLaw{5e-5, 0}, CarterLaw{5e-5, 1e-4}}) {
    CAPTURE(law.coefficient, law.spurt_volume);
    // Half a per cent is half a node of 0.5 m in the longest.
    CHECK(flooded_length(law, 0.5, 0.1, 100) == Approx(exact_length(law, 100)).epsilon(5e-3));
  }
}

TEST_CASE("Carter balance: the length does not depend on the interval, because demand is cumulative",
          "[network][verification]") {
  const CarterLaw law{5e-5, 0};
  const double exact = exact_length(law, 100);
  for (const double interval : {0.05, 0.2, 1.0}) {
    CAPTURE(interval);
    CHECK(flooded_length(law, 0.5, interval, 100) == Approx(exact).epsilon(1e-2));
  }
}
