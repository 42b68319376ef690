// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "common/errors.hpp"
#include "tests/network/flow_setup.hpp"

using namespace fissura;
using namespace fissura::network;
using namespace fissura::network::test;

namespace {

/// The tip node becomes interior and a new tip grows from it.
Insertion next_tip(const FlowSetup& setup, double h) {
  Insertion insertion;
  insertion.revision = setup.graph.network().revision() + 1;
  NetworkNode tip = setup.graph.network().nodes().back();
  insertion.new_nodes.push_back(tip);
  insertion.new_nodes.front().id = tip.id + 1;
  insertion.new_nodes.front().x += h;
  insertion.new_nodes.front().exposure_time = setup.state.time;
  insertion.parents.push_back({tip.id + 1, tip.id});
  insertion.new_segments.push_back(
      {.id = tip.id, .node_a = tip.id, .node_b = tip.id + 1, .fracture = 1, .length = h});
  tip.role = NodeRole::interior;
  tip.lumped_length = h;
  insertion.updated_nodes.push_back(tip);
  return insertion;
}

/// A quarter of the nodes gains, loses or closes its aperture between two intervals, as a structure might
/// have it.
void shake(FlowSetup& setup, std::mt19937& random) {
  std::uniform_real_distribution<double> any(0, 1);
  for (std::size_t i = 0; i < setup.graph.node_count(); ++i) {
    const double dice = any(random);
    setup.interval.aperture[i] = dice < 0.2 ? 0 : 1e-3 * any(random);
    setup.interval.faces[i] = dice < 0.3 ? Faces::in_contact : Faces::separated;
    setup.interval.compliance[i] = 1e-9 * any(random);
    setup.interval.reference_pressure[i] = 1e7 * any(random);
  }
}

}  // namespace

TEST_CASE("content: exact to rounding over random apertures, insertions and leak-off", "[network][content]") {
  Model model = water_model();
  model.schedule = constant_rate(1e-3);
  model.leak_off = {5e-5, 1e-5};
  FlowSetup setup(model, straight_fracture(5, 0.5, {0}));
  std::mt19937 random(11);
  double worst = 0;
  for (int k = 0; k < 400; ++k) {
    shake(setup, random);
    setup.advance(0.01);
    if (k % 7 == 3) setup.insert(next_tip(setup, 0.5));
    const FluidLedger ledger = ledger_report(setup.model, setup.graph, setup.state);
    worst = std::max(worst, std::abs(ledger.residual()) / (ledger.injected + ledger.in_place));
  }
  // Rounding of a few hundred sums.
  CHECK(worst <= 1e-12);
  CHECK(ledger_report(setup.model, setup.graph, setup.state).leaked > 0);
}

TEST_CASE("content: a single perforation injects exactly Q dt", "[network][content]") {
  Model model = water_model();
  model.schedule = constant_rate(1e-3);
  FlowSetup setup(model, straight_fracture(9, 0.5, {4}));
  setup.set_rigid(1e-3);
  setup.interval.compliance.assign(9, 1e-10);
  double time = 0;
  for (int k = 0; k < 100; ++k) {
    setup.advance(0.01);
    time += 0.01;
    CHECK(setup.state.perforation_rate.front() == 1e-3);
  }
  CHECK(setup.state.ledger.injected.value() == Approx(1e-3 * time).epsilon(1e-14));
  CHECK(setup.stored() == Approx(1e-3 * 4 + 1e-3 * time).epsilon(1e-14));
}

TEST_CASE("content: 1/K_n is no storage - the compliance changes the pressure of a content, not the content",
          "[network][content]") {
  for (const double compliance : {1e-12, 1e-10, 1e-8}) {
    Model model = water_model();
    model.schedule = constant_rate(1e-3);
    FlowSetup setup(model, straight_fracture(9, 0.5, {4}));
    setup.set_rigid(1e-3);
    setup.interval.compliance.assign(9, compliance);
    setup.interval.reference_pressure.assign(9, 5e6);
    for (int k = 0; k < 20; ++k) setup.advance(0.01);
    CAPTURE(compliance);
    CHECK(setup.stored() == Approx(1e-3 * 4 + 1e-3 * 0.2).epsilon(1e-14));
    // Nothing pumped and the aperture as predicted: the pressure stays, whatever the compliance.
    setup.model.schedule = Schedule();
    for (std::size_t i = 0; i < 9; ++i) {
      setup.state.pressure[i] = setup.interval.reference_pressure[i] = 7e6;
      setup.interval.aperture[i] = setup.state.content[i] / (1 + 7e6 / 2e9);
    }
    setup.advance(0.01);
    for (const double pressure : setup.state.pressure) CHECK(pressure == Approx(7e6).epsilon(1e-9));
  }
}

TEST_CASE(
    "content: what is carried is the content - a structure that opened more than predicted lowers the "
    "pressure",
    "[network][content]") {
  FlowSetup setup(water_model(), straight_fracture(5, 0.5, {}));
  setup.set_rigid(1e-3);
  setup.interval.compliance.assign(5, 1e-10);
  setup.advance(0.01);
  const double before = setup.stored();
  setup.interval.aperture.assign(5, 1.1e-3);
  setup.interval.reference_pressure.assign(5, 5e6);
  setup.advance(0.01);
  CHECK(setup.stored() == before);
  CHECK(setup.state.ledger.reset.value() == 0);
  // 1e-3 = (1.1e-3 + 1e-10 (p - 5e6)) (1 + p / 2e9)
  const double p = setup.state.pressure[2];
  CHECK((1.1e-3 + 1e-10 * (p - 5e6)) * (1 + p / 2e9) == Approx(1e-3).epsilon(1e-10));
  CHECK(p < 4.1e6);
}

TEST_CASE("content: with carry = pressure the content is made anew and the difference booked as reset",
          "[network][content]") {
  FlowSetup setup(water_model(), straight_fracture(5, 0.5, {}));
  setup.set_rigid(1e-3);
  setup.advance(0.01);
  setup.interval.carry = Carry::pressure;
  setup.interval.aperture.assign(5, 1.1e-3);
  setup.interval.aperture_rate.assign(5, 1e-3);
  setup.interval.compliance.assign(5, 1e-10);
  setup.advance(0.01);
  CHECK(setup.state.ledger.reset.value() == Approx(2 * 1e-4).epsilon(1e-12));
  const FluidLedger ledger = ledger_report(setup.model, setup.graph, setup.state);
  CHECK(std::abs(ledger.residual()) <= 1e-15 * ledger.in_fractures);
  // The rate opens the fracture by 1e-5 m within the interval: it drains.
  CHECK(setup.state.filled[2] == Approx(1.1 / 1.11).epsilon(1e-10));
}

TEST_CASE("content: a new tip of zero aperture and content rises to its opening pressure and opens beyond it",
          "[network][content]") {
  Model model = water_model();
  model.schedule = constant_rate(1e-4);
  FlowSetup setup(model, straight_fracture(5, 0.5, {0}));
  setup.set_rigid(1e-3);
  setup.interval.compliance.assign(5, 1e-10);
  setup.interval.reference_pressure.assign(5, 5e6);
  setup.advance(1.0);
  setup.insert(next_tip(setup, 0.5));
  CHECK(setup.state.content.back() == 0);
  setup.interval.faces.back() = Faces::in_contact;
  setup.interval.compliance.back() = 1e-10;
  setup.interval.reference_pressure.back() = 20e6;
  setup.advance(0.01);
  CHECK(setup.state.pressure.back() == Approx(setup.state.pressure[4]).epsilon(1e-6));
  // Closed and without aperture it stores nothing but what the tolerance of the solution leaves.
  CHECK(std::abs(setup.state.content.back()) < 1e-12);
  setup.interval.reference_pressure.back() = 2e6;
  setup.advance(0.1);
  CHECK(setup.state.content.back() ==
        Approx(1e-10 * (setup.state.pressure.back() - 2e6) * (1 + setup.state.pressure.back() / 2e9))
            .epsilon(1e-6));
}

TEST_CASE("content: conserved when lumped lengths change, also where a segment is split",
          "[network][content]") {
  Model model = water_model();
  model.leak_off = {5e-5, 0};
  FlowSetup setup(model, straight_fracture(3, 1.0, {}));
  setup.set_rigid(1e-3);
  setup.advance(1.0);
  const double before = setup.stored();
  const auto leaked = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < setup.graph.node_count(); ++i)
      sum += setup.graph.lumped_length()[i] * setup.state.leaked[i];
    return sum;
  };
  const double leaked_before = leaked();
  Insertion split;
  split.revision = 1;
  split.updated_nodes = setup.graph.network().nodes();
  split.updated_nodes[1].lumped_length = 0.75;
  split.updated_nodes[2].lumped_length = 0.25;
  split.updated_nodes.erase(split.updated_nodes.begin());
  split.removed_segments = {2};
  split.new_nodes.push_back({.id = 9, .x = 1.5, .y = 0, .lumped_length = 0.5, .exposure_time = 1.0});
  split.new_segments.push_back({.id = 10, .node_a = 2, .node_b = 9, .length = 0.5});
  split.new_segments.push_back({.id = 11, .node_a = 9, .node_b = 3, .length = 0.5});
  setup.insert(split);
  CHECK(setup.stored() == Approx(before).epsilon(1e-14));
  CHECK(leaked() == Approx(leaked_before).epsilon(1e-14));
  CHECK(setup.state.content[3] == Approx(setup.state.content[1]).epsilon(1e-14));
  Insertion longer;
  longer.revision = 2;
  longer.updated_nodes = {setup.graph.network().nodes()[0]};
  longer.updated_nodes[0].lumped_length = 1.0;
  setup.insert(longer);
  CHECK(setup.stored() == Approx(before).epsilon(1e-14));
}

TEST_CASE("content: producing more than a node holds is refused with the node and the value",
          "[network][content]") {
  Model model = water_model();
  model.schedule = constant_rate(-1.0);
  FlowSetup setup(model, straight_fracture(3, 0.5, {1}));
  setup.set_rigid(1e-4);
  CHECK_THROWS_WITH(setup.advance(0.1), Catch::Contains("fluid content of node 2 is -"));
}
