// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "common/errors.hpp"
#include "tests/network/natural_setup.hpp"

using namespace fissura;
using namespace fissura::network;
using namespace fissura::network::test;

namespace {

constexpr double water_modulus = 2e9, water_viscosity = 1.67e-3;

/// A straight natural fracture in touch, found at 5 MPa, with the well at its first node.
FlowSetup touching_fracture(Model model, std::size_t nodes, double h, const NaturalFracture& natural) {
  Insertion insertion = straight_fracture(nodes, h, {0}, SegmentKind::natural);
  for (NetworkNode& node : insertion.new_nodes) {
    node.saturated = true;
    node.formation_pressure = natural.formation_pressure;
    node.joint_compliance = natural.joint_compliance;
  }
  FlowSetup setup(std::move(model), insertion);
  setup.set_rigid(natural.residual_aperture);
  setup.interval.compliance.assign(nodes, 2e-10);
  setup.interval.reference_pressure.assign(nodes, natural.opening_pressure);
  setup.interval.faces.assign(nodes, Faces::in_contact);
  return setup;
}

}  // namespace

TEST_CASE("found: a natural fracture joins full of pore fluid at formation pressure", "[network][natural]") {
  NaturalSetup setup = pumped_fracture(water_model(), 1e-3);
  setup.advance(0.1);
  const NaturalFracture natural;
  setup.join({4}, 3, natural);
  CHECK(setup.flow.state.ledger.found.value() == 0);
  const double stored = setup.flow.stored();
  setup.advance(1e-9);
  // Seven nodes of 0.5 m, the outer ones of half; the dry mouth of the stem in the junction holds nothing.
  const double volume = 5e-5 * (1 + 5e6 / water_modulus) * 6 * 0.5;
  CHECK(setup.flow.state.ledger.found.value() == Approx(volume).epsilon(1e-12));
  CHECK(setup.flow.stored() - stored == Approx(volume).epsilon(1e-9));
  CHECK(setup.flow.state.pressure[6] == Approx(5e6).epsilon(1e-6));
  CHECK(setup.flow.state.filled[5] == 1);
  CHECK(setup.relative_residual() < 1e-14);
}

TEST_CASE("found: at time 0 it is in place", "[network][natural]") {
  FlowSetup setup = touching_fracture(water_model(), 5, 0.5, {});
  setup.model.schedule = Schedule();
  setup.advance(0.1);
  const FluidLedger ledger = ledger_report(setup.model, setup.graph, setup.state);
  CHECK(ledger.in_place == Approx(5e-5 * (1 + 5e6 / water_modulus) * 2).epsilon(1e-13));
  CHECK(ledger.found == 0);
  for (const double pressure : setup.state.pressure) CHECK(pressure == Approx(5e6).epsilon(1e-9));
}

TEST_CASE("found: once only, whatever grows from a node later", "[network][natural]") {
  NaturalSetup setup = pumped_fracture(water_model(), 1e-3);
  setup.advance(0.1);
  setup.join({4}, 3, {});
  setup.advance(0.1);
  const double found = setup.flow.state.ledger.found.value(), stored = setup.flow.stored();
  setup.grow(5);
  CHECK(setup.flow.stored() == Approx(stored).epsilon(1e-14));
  const double pressure = setup.flow.state.pressure[5];
  setup.advance(1e-9);
  CHECK(setup.flow.state.ledger.found.value() == found);
  // Content, aperture and joint compliance are spread over the longer node alike. A dry arm draws in 1 ns
  // what its conductance lets it.
  CHECK(setup.flow.state.pressure[5] == Approx(pressure).epsilon(1e-4));
}

TEST_CASE("joint compliance: pressure diffuses with D = e^3 / (12 mu (e / K_f + c_s))",
          "[network][natural]") {
  NaturalFracture natural;
  natural.joint_compliance = GENERATE(0.0, 1e-12, 1e-11);
  const double e = natural.residual_aperture, h = 0.25;
  const double diffusivity =
      e * e * e / (12 * water_viscosity * (e / water_modulus + natural.joint_compliance));
  const double end = 25 / diffusivity;  // the pressure has reached 10 m
  CAPTURE(natural.joint_compliance, end);
  Model model = water_model();
  model.well_index = 1e-3;
  // So little that the joint opens by less than 0.1 % of its aperture.
  constexpr double rise = 1e4;
  model.schedule = constant_pressure(5e6 + rise);
  FlowSetup setup = touching_fracture(model, 201, h, natural);
  for (int k = 0; k < 400; ++k) setup.advance(end / 400);
  for (const std::size_t node : {4, 12, 20, 40, 80}) {
    const double x = h * static_cast<double>(node);
    CAPTURE(x);
    // Backward Euler in 400 steps and cells of a fortieth of the depth: half a per cent of the rise.
    CHECK((setup.state.pressure[node] - 5e6) / rise ==
          Approx(std::erfc(x / std::sqrt(4 * diffusivity * end))).margin(5e-3));
  }
}

TEST_CASE("joint compliance: the joint's own opening conducts in natural arms, not in hydraulic ones",
          "[network][natural]") {
  NaturalSetup setup = pumped_fracture(water_model(), 1e-3);
  setup.advance(0.1);
  setup.join({4}, 3, {});
  setup.advance(1e-9);
  for (std::size_t i = 5; i < setup.count(); ++i) setup.flow.state.pressure[i] = 8e6;
  Step step;
  prepare_step(setup.flow.model, setup.flow.graph, setup.flow.interval, setup.flow.state,
               setup.flow.state.time + 0.1, step);
  const std::vector<NetworkSegment>& segments = setup.flow.graph.network().segments();
  // c_s (8 - 5) MPa = 30 um. The junction is 8, its mean aperture two thirds of its natural arms'.
  CHECK(segments[4].kind == SegmentKind::natural);
  CHECK(step.segment_aperture[4] == Approx(8e-5).epsilon(1e-12));
  CHECK(step.segment_aperture[6] == Approx(0.5 * (8e-5 + 5e-5 * 2 / 3 + 3e-5)).epsilon(1e-12));
  CHECK(segments[10].kind == SegmentKind::hydraulic);
  CHECK(step.segment_aperture[10] ==
        Approx(0.5 * (setup.flow.interval.aperture[4] + 5e-5 * 2 / 3)).epsilon(1e-12));
}

TEST_CASE("aperture per arm: a segment conducts with the apertures of its own arm", "[network][natural]") {
  NaturalSetup setup = pumped_fracture(water_model(), 1e-3);
  setup.advance(0.1);
  setup.join({4}, 3, {});
  const std::size_t segments = setup.flow.graph.segment_count();
  setup.flow.interval.arm_aperture_a.assign(segments, 1e-4);
  setup.flow.interval.arm_aperture_b.assign(segments, 3e-4);
  setup.flow.interval.arm_aperture_b[10] = 0;
  Step step;
  prepare_step(setup.flow.model, setup.flow.graph, setup.flow.interval, setup.flow.state,
               setup.flow.state.time + 0.1, step);
  CHECK(step.segment_aperture[0] == Approx(2e-4).epsilon(1e-14));
  CHECK(step.segment_aperture[10] == Approx(0.5 * (1e-4 + setup.flow.model.minimum_aperture)).epsilon(1e-14));
}

TEST_CASE("joint compliance: nothing jumps where faces part or meet again", "[network][natural]") {
  FlowSetup setup = touching_fracture(water_model(), 5, 0.5, {});
  setup.advance(0.1);
  const auto content = [&] { return setup.state.content[2] / (1 + setup.state.pressure[2] / water_modulus); };
  CHECK(setup.state.contact_pressure[2] == 12e6);
  // Below it the pressure at which the contact would open follows the stress; above it the opening stays.
  setup.interval.reference_pressure.assign(5, 9e6);
  setup.advance(0.1);
  CHECK(setup.state.contact_pressure[2] == 9e6);
  setup.state.pressure.assign(5, 10e6);
  setup.state.content.assign(5, (5e-5 + 1e-11 * 4e6) * (1 + 10e6 / water_modulus));
  setup.interval.faces.assign(5, Faces::separated);
  setup.interval.reference_pressure.assign(5, 10e6);
  setup.advance(0.1);
  CHECK(setup.state.pressure[2] == Approx(10e6).epsilon(1e-9));
  setup.interval.faces.assign(5, Faces::in_contact);
  setup.interval.reference_pressure.assign(5, 13e6);
  setup.advance(0.1);
  CHECK(setup.state.contact_pressure[2] == 9e6);
  CHECK(setup.state.pressure[2] == Approx(10e6).epsilon(1e-9));
  CHECK(content() == Approx(9e-5).epsilon(1e-9));
}

TEST_CASE("natural fractures: the ledger closes through fifty random connections with leak-off",
          "[network][natural]") {
  const unsigned seed = GENERATE(1u, 2u, 3u);
  CAPTURE(seed);
  Model model = water_model();
  model.schedule = constant_rate(1e-3);
  model.leak_off = {1e-5, 1e-6};
  NaturalSetup setup = pumped_fracture(model, 1e-4);
  std::mt19937 random(seed);
  double worst = 0;
  int halvings = 0, most_iterations = 0;
  for (int connection = 0; connection < 50; ++connection) {
    std::vector<std::size_t> from;
    for (auto k = random() % 3 + 1; k > 0; --k) from.push_back(random() % setup.count());
    NaturalFracture natural;
    natural.joint_compliance = std::array{0.0, 1e-12, 1e-11, 1e-10}[random() % 4];
    natural.residual_aperture = random() % 4 == 0 ? 0 : 5e-5;
    natural.formation_pressure = 1e6 * static_cast<double>(random() % 10);
    natural.opening_pressure = natural.formation_pressure + 1e6 * static_cast<double>(1 + random() % 6);
    setup.join(from, 1 + random() % 4, natural);
    if (connection % 2 == 0) setup.grow(random() % setup.count());
    for (int k = 0; k < 3; ++k) {
      const AdvanceReport report = setup.advance(0.01 * static_cast<double>(1 + random() % 10));
      worst = std::max(worst, setup.relative_residual());
      halvings += report.halvings;
      most_iterations = std::max(most_iterations, report.newton.iterations);
    }
  }
  const FluidLedger ledger = ledger_report(setup.flow.model, setup.flow.graph, setup.flow.state);
  CHECK(ledger.found > 0);
  CHECK(ledger.leaked > 0);
  // Rounding of the sum over some hundred nodes.
  CHECK(worst < 1e-13);
  CHECK(halvings == 0);
  CHECK(most_iterations <= 40);
}

TEST_CASE("Newton: a closed network is connected to an open fracture 1 MPa above it without halving",
          "[network][natural]") {
  const double compliance = GENERATE(0.0, 1e-11), duration = GENERATE(1e-4, 1e-2, 1.0);
  CAPTURE(compliance, duration);
  NaturalSetup setup = pumped_fracture(water_model(), 1e-3);
  setup.advance(0.1);
  for (std::size_t i = 0; i < 5; ++i) {
    setup.flow.state.pressure[i] = setup.flow.interval.reference_pressure[i] = 6e6;
    setup.flow.state.content[i] = 1e-3 * (1 + 6e6 / water_modulus);
    setup.flow.interval.aperture[i] = 1e-3;
    setup.flow.interval.faces[i] = Faces::separated;
  }
  NaturalFracture natural;
  natural.joint_compliance = compliance;
  setup.join({4}, 40, natural);
  setup.join({30}, 40, natural);
  setup.grow(60);
  for (int k = 0; k < 20; ++k) {
    const AdvanceReport report = setup.advance(duration);
    CHECK(report.halvings == 0);
    CHECK(report.newton.iterations <= 20);
    for (std::size_t i = 0; i < setup.count(); ++i) CHECK(setup.flow.state.pressure[i] <= 6e6 * (1 + 1e-9));
  }
}

TEST_CASE("natural fractures: no junction has more pressure than the inlet", "[network][natural]") {
  Model model = water_model();
  model.well_index = 1e-3;
  model.schedule = constant_pressure(7e6);
  NaturalSetup setup = pumped_fracture(model, 5e-4);
  setup.flow.interval.compliance.assign(5, 0.0);
  for (int k = 0; k < 20; ++k) setup.flow.advance(0.1);
  setup.join({4}, 10, {});
  setup.join({10, 20}, 6, {});
  for (int k = 0; k < 200; ++k) {
    setup.flow.advance(0.05);
    const std::vector<double>& pressure = setup.flow.state.pressure;
    // The tolerance of Newton.
    for (const double value : pressure) CHECK(value <= pressure[0] * (1 + 1e-9));
  }
  CHECK(setup.flow.state.pressure.back() > 5e6);
}

TEST_CASE("natural fractures: a symmetric network has symmetric pressures", "[network][natural]") {
  Model model = water_model();
  model.schedule = constant_rate(1e-2);
  model.leak_off = {1e-5, 0};
  NaturalSetup setup(model, straight_fracture(9, 0.5, {4}));
  setup.flow.set_rigid(5e-4);
  setup.flow.interval.compliance.assign(9, 1e-9);
  setup.advance(0.5);
  setup.join({0, 8}, 4, {});
  for (int k = 0; k < 100; ++k) setup.advance(0.02);
  const std::vector<double>& pressure = setup.flow.state.pressure;
  for (std::size_t i = 0; i < 4; ++i) CHECK(pressure[i] == Approx(pressure[8 - i]).epsilon(1e-8));
  for (std::size_t i = 0; i < 9; ++i) CHECK(pressure[9 + i] == Approx(pressure[18 + i]).epsilon(1e-8));
  for (std::size_t i = 0; i < 4; ++i) CHECK(pressure[9 + i] == Approx(pressure[17 - i]).epsilon(1e-8));
  CHECK(pressure[13] > 5.1e6);
}
