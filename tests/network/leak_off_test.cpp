// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/network/natural_setup.hpp"

using namespace fissura;
using namespace fissura::network;
using namespace fissura::network::test;

namespace {

Model leaking_model(double coefficient) {
  Model model = water_model();
  model.leak_off = {coefficient, 0};
  return model;
}

/// Node 3 is released at 1 s as the tip of a fracture of two nodes.
Insertion released_tip(double exposure_time) {
  Insertion insertion;
  insertion.revision = 1;
  insertion.new_nodes.push_back(
      {.id = 3, .x = 1, .lumped_length = 0.25, .role = NodeRole::tip, .exposure_time = exposure_time});
  insertion.parents.push_back({3, 2});
  insertion.new_segments.push_back({.id = 2, .node_a = 2, .node_b = 3, .length = 0.5});
  return insertion;
}

}  // namespace

TEST_CASE("leak-off: an open notch loses 4 C_l sqrt(t) per trace length whatever the intervals",
          "[network][leak-off]") {
  for (const double duration : {0.01, 0.1, 1.0}) {
    FlowSetup setup(leaking_model(5e-5), straight_fracture(3, 0.5, {}));
    setup.set_rigid(1e-3);
    while (setup.state.time < 4 - 1e-9) setup.advance(duration);
    for (const double leaked : setup.state.leaked) CHECK(leaked == Approx(4 * 5e-5 * 2).epsilon(1e-9));
  }
}

TEST_CASE(
    "leak-off: demand that a dry tip could not meet is taken when fluid arrives (capped, incremental "
    "leak-off "
    "loses it)",
    "[network][leak-off]") {
  FlowSetup setup(leaking_model(5e-5), straight_fracture(2, 0.5, {0}));
  setup.interval.aperture.front() = 1e-3;
  setup.advance(1e-9);
  setup.insert(released_tip(setup.state.time));
  setup.set_rigid(1e-3);
  const double released = setup.state.time;
  // No pumping: the notch is drunk dry long before the tip sees anything.
  for (int k = 0; k < 50; ++k) setup.advance(0.1);
  CHECK(setup.state.leaked[2] < 1e-12);
  setup.model.schedule = constant_rate(1e-3);
  for (int k = 0; k < 20; ++k) setup.advance(0.1);
  CHECK(setup.state.filled[2] == 1);
  // The front still stands in the tip's cell, which is exposed evenly since its release.
  const double age = setup.state.time - released;
  CHECK(setup.state.leaked[2] == Approx(4 * 5e-5 * 2.0 / 3.0 * std::sqrt(age)).epsilon(1e-9));
}

TEST_CASE("leak-off: a cell is swept from its own release to that of the next node", "[network][leak-off]") {
  FlowSetup setup(leaking_model(1e-5), straight_fracture(2, 0.5, {}));
  setup.set_rigid(1e-3);
  setup.advance(1.0);
  setup.insert(released_tip(1.0));
  CHECK(setup.state.exposure[1].end == 0);
  CHECK(setup.state.exposure[2].front == Front::inside);
  setup.set_rigid(1e-3);
  setup.state.content[2] = 1e-3;
  setup.advance(0.5);
  Insertion next = released_tip(1.5);
  next.revision = 2;
  next.new_nodes.front().id = 4;
  next.parents = {{4, 3}};
  next.new_segments = {{.id = 3, .node_a = 3, .node_b = 4, .length = 0.5}};
  NetworkNode former_tip = setup.graph.network().nodes()[2];
  former_tip.role = NodeRole::interior;
  next.updated_nodes = {former_tip};
  setup.insert(next);
  CHECK(setup.state.exposure[2].front == Front::passed);
  CHECK(setup.state.exposure[2].begin == 1.0);
  CHECK(setup.state.exposure[2].end == 1.5);
  CHECK(setup.state.exposure[3].residence == 0.5);
  setup.set_rigid(1e-3);
  setup.advance(2.0);
  CHECK(setup.state.leaked[2] == Approx(cell_leak_off({1e-5, 0}, 1.0, 1.5, 3.5)).epsilon(1e-9));
}

TEST_CASE("leak-off: a natural fracture loses nothing before the fluid reaches it", "[network][leak-off]") {
  Model model = leaking_model(1e-5);
  model.schedule = constant_rate(1e-4);
  FlowSetup setup(model, straight_fracture(6, 0.5, {0}, SegmentKind::natural));
  setup.interval.aperture.front() = 1e-3;
  setup.advance(1e-9);
  setup.set_rigid(1e-3);
  CHECK(setup.state.exposure[0].front == Front::inside);
  CHECK(setup.state.exposure[5].front == Front::ahead);
  while (setup.state.exposure[3].front == Front::ahead) setup.advance(0.1);
  CHECK(setup.state.exposure[2].front == Front::passed);
  CHECK(setup.state.exposure[3].front == Front::inside);
  CHECK(setup.state.exposure[3].begin == setup.state.time);
  CHECK(setup.state.exposure[2].end == setup.state.time);
  CHECK(setup.state.leaked[5] == 0);
}

TEST_CASE("leak-off: a closed, dry node lets its demand go, so that a refill is not swallowed",
          "[network][leak-off]") {
  FlowSetup setup(leaking_model(1e-5), straight_fracture(3, 0.5, {0}));
  setup.set_rigid(1e-5);
  for (int k = 0; k < 20; ++k) setup.advance(1.0);
  CHECK(setup.state.filled[1] < 0.01);
  setup.interval.faces.assign(3, Faces::in_contact);
  for (int k = 0; k < 400; ++k) setup.advance(1.0);
  const double lost = setup.state.leaked[1];
  setup.interval.faces.assign(3, Faces::separated);
  setup.set_rigid(1e-3);
  setup.model.schedule = constant_rate(1e-2);
  setup.advance(0.5);
  // Without the waiver 4 C_l sqrt(420) = 8.2e-4 m would be asked for at once.
  CHECK(setup.state.leaked[1] - lost < 1e-5);
  CHECK(setup.state.filled[1] == 1);
}

TEST_CASE("leak-off: demand beyond the content empties the node and keeps the ledger",
          "[network][leak-off]") {
  FlowSetup setup(leaking_model(1e-3), straight_fracture(5, 0.5, {2}));
  setup.set_rigid(1e-4);
  for (int k = 0; k < 50; ++k) {
    setup.advance(0.01);
    for (const double content : setup.state.content) CHECK(content >= 0);
  }
  const FluidLedger ledger = ledger_report(setup.model, setup.graph, setup.state);
  CHECK(ledger.leaked == Approx(1e-4 * 2).epsilon(1e-12));
  CHECK(std::abs(ledger.residual()) <= 1e-18);
}

TEST_CASE("leak-off: pore fluid that moves does not wet a natural fracture, injected fluid does",
          "[network][leak-off]") {
  Model model = leaking_model(1e-6);
  NaturalSetup setup = pumped_fracture(model, 1e-3);
  setup.advance(0.1);
  setup.join({4}, 5, {});
  // The dry tip draws pore fluid out of the natural fracture.
  for (int k = 0; k < 20; ++k) setup.advance(0.1);
  const std::vector<Exposure>& exposure = setup.flow.state.exposure;
  for (std::size_t i = 5; i < setup.count(); ++i) {
    CHECK(exposure[i].front == Front::ahead);
    CHECK(setup.flow.state.leaked[i] == 0);
  }
  setup.flow.model.schedule = constant_rate(1e-3);
  while (exposure[10].front == Front::ahead) setup.advance(0.01);
  CHECK(exposure[9].front == Front::ahead);
  CHECK(exposure[11].front == Front::ahead);
  CHECK(setup.flow.state.arrived[10] > setup.flow.state.pore_content[10]);
  while (exposure[5].front == Front::ahead && setup.flow.state.time < 1e3) setup.advance(0.02);
  // The front passes one node after the other.
  for (std::size_t i = 5; i < 10; ++i) {
    CHECK(exposure[i].begin > exposure[i + 1].begin);
    CHECK(exposure[i + 1].front == Front::passed);
    CHECK(exposure[i + 1].end == exposure[i].begin);
  }
  CHECK(setup.flow.state.leaked[10] > 0);
}

TEST_CASE("leak-off: the front of the injected fluid replaces the pore fluid like a piston",
          "[network][leak-off]") {
  Model model = leaking_model(0);
  model.schedule = constant_rate(1e-5);
  Insertion insertion = straight_fracture(41, 0.5, {0}, SegmentKind::natural);
  for (NetworkNode& node : insertion.new_nodes) node.saturated = true;
  FlowSetup setup(model, insertion);
  setup.set_rigid(1e-4);
  // The far end is open to a sink that takes what comes.
  setup.interval.aperture.back() = 1;
  const double interval = GENERATE(0.5, 5.0, 20.0);
  CAPTURE(interval);
  while (setup.state.time < 100) setup.advance(interval);
  const double behind = 1e-5 * 100 / 1e-4;
  const auto wet = static_cast<double>(
      std::count_if(setup.state.exposure.begin(), setup.state.exposure.end(),
                    [](const Exposure& exposure) { return exposure.front != Front::ahead; }));
  CHECK(std::abs(0.5 * wet - 0.25 - behind) <= 0.5);
}
