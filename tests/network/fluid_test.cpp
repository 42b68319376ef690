// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "network/laws/cubic_law.hpp"
#include "tests/network/flow_setup.hpp"

using namespace fissura;
using namespace fissura::network;
using namespace fissura::network::test;

namespace {

/// A rigid fracture whose far end swallows fluid at a constant pressure: a very compliant node.
FlowSetup drained_fracture(Model model, std::size_t nodes, double aperture) {
  FlowSetup setup(std::move(model), straight_fracture(nodes, 0.5, {0}));
  setup.set_rigid(aperture);
  setup.interval.compliance.back() = 1e3;
  setup.interval.reference_pressure.assign(nodes, 1e6);
  return setup;
}

double volume_of(const FlowSetup& setup, std::size_t fluid) {
  double sum = 0;
  for (std::size_t i = 0; i < setup.graph.node_count(); ++i)
    sum += setup.graph.lumped_length()[i] * setup.state.content[i] *
           setup.state.fluid_fraction[i * setup.model.fluids.size() + fluid];
  return sum;
}

}  // namespace

TEST_CASE("power law: from rest the first interval already has the pressure of the flow",
          "[network][fluid]") {
  for (const double n : {0.3, 0.5, 0.8, 1.3}) {
    Model model = water_model();
    // Gradients of some 1e5 Pa/m at every n, so that the compression of the fluid plays no part.
    model.fluids.front().law = {50 * std::pow(1e4, -n), n};
    model.schedule = constant_rate(5e-4);
    FlowSetup setup = drained_fracture(model, 9, 1e-3);
    setup.advance(1.0);
    const double exact = gradient_from_velocity(model.fluids.front().law, 1e-3, 0.5) * 4.0;
    CAPTURE(n);
    // The secants may be wrong by secant_tolerance.
    CHECK(setup.state.pressure.front() - setup.state.pressure.back() == Approx(exact).epsilon(2e-2));
    for (int k = 0; k < 8; ++k) setup.advance(1.0);
    CHECK(setup.state.pressure.front() - setup.state.pressure.back() == Approx(exact).epsilon(1e-3));
  }
}

TEST_CASE("power law: given pressures drive the flow of the law", "[network][fluid]") {
  Model model = water_model();
  model.fluids.front().law = {0.5, 0.5};
  model.well_index = 1;
  model.schedule = constant_pressure(1.2e6);
  FlowSetup setup = drained_fracture(model, 9, 1e-3);
  for (int k = 0; k < 12; ++k) setup.advance(1.0);
  const double velocity = setup.state.rate / 1e-3;
  CHECK(gradient_from_velocity(model.fluids.front().law, 1e-3, velocity) * 4.0 ==
        Approx(0.2e6).epsilon(2e-3));
}

TEST_CASE("fluids: a change in the schedule displaces the old fluid and both are conserved",
          "[network][fluid]") {
  Model model = water_model();
  model.fluids.push_back({"gel", {0.1, 1}, 2e9});
  model.schedule =
      Schedule({{.begin = 0, .control = WellControl::rate, .target = 1e-3, .ramp = 0, .fluid = 0},
                {.begin = 2, .control = WellControl::rate, .target = 1e-3, .ramp = 0, .fluid = 1}});
  FlowSetup setup = drained_fracture(model, 9, 1e-3);
  for (int k = 0; k < 20; ++k) setup.advance(0.1);
  const double thin = setup.state.pressure.front() - setup.state.pressure.back();
  CHECK(thin == Approx(1e-3 * 4 / transmissibility(1e-3, 1.67e-3, 1)).epsilon(1e-6));
  CHECK(volume_of(setup, 1) == Approx(0).margin(1e-15));  // 20 times 0.1 s may end just after 2 s
  const double water = volume_of(setup, 0);
  for (int k = 0; k < 1000; ++k) setup.advance(0.1);
  CHECK(volume_of(setup, 0) == Approx(water).epsilon(1e-12));
  CHECK(volume_of(setup, 1) == Approx(1e-3 * 100).epsilon(1e-12));
  CHECK(setup.state.fluid_fraction[1] == Approx(1).epsilon(1e-12));
  const double thick = setup.state.pressure.front() - setup.state.pressure[7];
  CHECK(thick == Approx(1e-3 * 3.5 / transmissibility(1e-3, 0.1, 1)).epsilon(1e-6));
}

TEST_CASE("fluids: fractions stay fractions in intervals that turn every cell over many times",
          "[network][fluid]") {
  Model model = water_model();
  model.fluids.push_back({"gel", {0.1, 1}, 1e9});
  model.schedule =
      Schedule({{.begin = 0, .control = WellControl::rate, .target = 1e-3, .ramp = 0, .fluid = 0},
                {.begin = 1, .control = WellControl::rate, .target = 1e-3, .ramp = 0, .fluid = 1}});
  FlowSetup setup = drained_fracture(model, 9, 1e-4);
  for (int k = 0; k < 20; ++k) {
    setup.advance(0.5);
    for (std::size_t i = 0; i < 9; ++i) {
      CHECK(setup.state.fluid_fraction[2 * i] >= 0);
      CHECK(setup.state.fluid_fraction[2 * i] + setup.state.fluid_fraction[2 * i + 1] ==
            Approx(1).epsilon(1e-14));
    }
  }
  CHECK(setup.state.fluid_fraction[1] > 0.999);
}

TEST_CASE("fluids: what a shut-in well passes from one perforation to another keeps its kind",
          "[network][fluid]") {
  Model model = water_model();
  model.fluids.push_back({"gel", {0.1, 1}, 2e9});
  Insertion insertion = straight_fracture(4, 0.5, {0, 3});
  insertion.new_segments.erase(insertion.new_segments.begin() + 1);
  FlowSetup setup(model, insertion);
  setup.set_rigid(1e-3);
  setup.interval.compliance.assign(4, 1e-10);
  setup.interval.reference_pressure = {4e6, 3.9e6, 0, 0};
  for (std::size_t i : {0, 1}) {
    setup.state.fluid_fraction[2 * i] = 0;
    setup.state.fluid_fraction[2 * i + 1] = 1;
  }
  setup.advance(1e-9);
  setup.advance(1e-9);
  const double gel = volume_of(setup, 1);
  for (int k = 0; k < 50; ++k) setup.advance(1.0);
  CHECK(volume_of(setup, 1) == Approx(gel).epsilon(1e-12));
  CHECK(setup.state.fluid_fraction[2 * 3 + 1] > 0.01);
}
