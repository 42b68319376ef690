// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "tests/network/flow_setup.hpp"

using namespace fissura;
using namespace fissura::network;
using namespace fissura::network::test;

namespace {

/// Two fractures that only the well connects: nodes 0..3 and 4..7, a perforation in each.
FlowSetup two_fractures(const Schedule& schedule) {
  Insertion insertion = straight_fracture(8, 0.5, {1, 5});
  insertion.new_segments.erase(insertion.new_segments.begin() + 3);
  Model model = water_model();
  model.schedule = schedule;
  FlowSetup setup(model, insertion);
  setup.set_rigid(1e-3);
  setup.interval.compliance.assign(8, 1e-10);
  return setup;
}

Schedule stages(std::vector<PumpingStage> list) {
  return Schedule(std::move(list));
}

}  // namespace

TEST_CASE("well: perforations share one pressure and together take exactly the rate", "[network][well]") {
  FlowSetup setup = two_fractures(constant_rate(1e-3));
  for (std::size_t i = 4; i < 8; ++i) setup.interval.reference_pressure[i] = 2e5;
  setup.advance(0.5);
  const std::vector<double>& rate = setup.state.perforation_rate;
  CHECK(rate[0] + rate[1] == Approx(1e-3).epsilon(1e-15));
  CHECK(rate[0] > rate[1]);
  for (int k : {0, 1}) {
    const double node_pressure = setup.state.pressure[k == 0 ? 1 : 5];
    CHECK(setup.state.well_pressure - node_pressure ==
          Approx(rate[k] / setup.model.well_index).epsilon(1e-6));
  }
}

TEST_CASE("well: shut in, perforations exchange through the well and nothing enters or leaves",
          "[network][well]") {
  FlowSetup setup = two_fractures(Schedule());
  for (std::size_t i = 0; i < 4; ++i) setup.interval.reference_pressure[i] = 4e6;
  const double stored = 8 * 0.5 * 1e-3 - 2 * 0.25e-3;
  setup.advance(0.01);
  CHECK(setup.state.perforation_rate[0] < 0);
  CHECK(std::abs(setup.state.perforation_rate[0] + setup.state.perforation_rate[1]) < 1e-18);
  for (int k = 0; k < 60; ++k) setup.advance(10);
  CHECK(setup.state.pressure[1] == Approx(setup.state.pressure[5]).epsilon(1e-6));
  CHECK(setup.state.ledger.injected.value() == Approx(0).margin(1e-17));
  CHECK(setup.stored() == Approx(stored).epsilon(1e-14));
}

TEST_CASE("well: a pressure inlet injects WI (p_w - p) and the volume is booked", "[network][well]") {
  FlowSetup setup = two_fractures(constant_pressure(6e6));
  setup.advance(1e-3);
  CHECK(setup.state.well_pressure == Approx(6e6).epsilon(1e-12));
  CHECK(setup.state.perforation_rate[0] ==
        Approx(setup.model.well_index * (6e6 - setup.state.pressure[1])).epsilon(1e-12));
  CHECK(setup.state.rate ==
        Approx(setup.state.perforation_rate[0] + setup.state.perforation_rate[1]).epsilon(1e-15));
  const FluidLedger ledger = ledger_report(setup.model, setup.graph, setup.state);
  CHECK(ledger.injected == Approx(1e-3 * setup.state.rate).epsilon(1e-12));
  for (int k = 0; k < 200; ++k) setup.advance(1);
  for (const double pressure : setup.state.pressure) CHECK(pressure == Approx(6e6).epsilon(1e-6));
}

TEST_CASE(
    "well: the pressure ramp of a flowback starts at the well's own pressure, and the fracture produces",
    "[network][well]") {
  FlowSetup setup = two_fractures(
      stages({{.begin = 0, .control = WellControl::rate, .target = 1e-3, .ramp = 0, .fluid = 0},
              {.begin = 1, .control = WellControl::pressure, .target = 1e6, .ramp = 0.2, .fluid = 0}}));
  setup.advance(1.0);
  const double at_switch = setup.state.well_pressure;
  setup.advance(0.1);
  CHECK(setup.state.well_pressure == Approx(0.5 * (at_switch + 1e6)).epsilon(1e-9));
  setup.advance(0.1);
  CHECK(setup.state.well_pressure == Approx(1e6).epsilon(1e-9));
  CHECK(setup.state.rate < 0);
  const double injected = setup.state.ledger.injected.value();
  CHECK(injected < 1e-3);
  for (int k = 0; k < 200; ++k) setup.advance(1);
  CHECK(setup.state.pressure[1] == Approx(1e6).epsilon(1e-6));
}

TEST_CASE("well: an interval across a change of the schedule injects the exact volume of both stages",
          "[network][well]") {
  FlowSetup setup = two_fractures(
      stages({{.begin = 0, .control = WellControl::rate, .target = 1e-3, .ramp = 0.3, .fluid = 0},
              {.begin = 0.55, .control = WellControl::rate, .target = 3e-3, .ramp = 0.1, .fluid = 0},
              {.begin = 0.9, .control = WellControl::rate, .target = 0, .ramp = 0, .fluid = {}}}));
  setup.advance(0.2);
  setup.advance(1.0);
  const double exact = 0.15 * 1e-3 + 0.25 * 1e-3 + 0.1 * 2e-3 + 0.25 * 3e-3;
  CHECK(setup.state.ledger.injected.value() == Approx(exact).epsilon(1e-14));
  CHECK(setup.state.rate == 0);
}

TEST_CASE("well: shut in with one perforation moves nothing through it", "[network][well]") {
  FlowSetup setup(water_model(), straight_fracture(5, 0.5, {2}));
  setup.set_rigid(1e-3);
  setup.interval.reference_pressure = {1e6, 2e6, 3e6, 4e6, 5e6};
  setup.interval.compliance.assign(5, 1e-10);
  setup.advance(0.1);
  CHECK(setup.state.perforation_rate.front() == 0);
  CHECK(setup.state.ledger.injected.value() == 0);
}
