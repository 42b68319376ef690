// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "common/errors.hpp"
#include "tests/network/flow_setup.hpp"

using namespace fissura;
using namespace fissura::network;
using namespace fissura::network::test;

namespace {

/// A dry, rigid fracture that is flooded from its end.
FlowSetup dry_fracture(Model model, std::size_t nodes) {
  model.schedule = constant_rate(1e-3);
  FlowSetup setup(std::move(model), straight_fracture(nodes, 0.5, {0}));
  setup.interval.aperture.front() = 1e-3;
  setup.advance(1e-9);
  setup.set_rigid(1e-3);
  return setup;
}

}  // namespace

TEST_CASE("Newton: the front floods a dry fracture at the speed of the rate", "[network][newton]") {
  FlowSetup setup = dry_fracture(water_model(), 41);
  for (int k = 0; k < 100; ++k) {
    const AdvanceReport report = setup.advance(0.1);
    CHECK(report.newton.converged);
  }
  const double wet = std::inner_product(setup.state.filled.begin(), setup.state.filled.end(),
                                        setup.graph.lumped_length().begin(), 0.0);
  // 0.1 s short of 10 m: the compressed fluid behind the front takes less room, by p / K_f.
  CHECK(wet == Approx(0.25 + 10.0).epsilon(1e-3));
  CHECK(setup.state.filled.back() == 0);
  CHECK(*std::min_element(setup.state.content.begin(), setup.state.content.end()) >= 0);
}

TEST_CASE("Newton: an interval that does not converge is halved, never accepted", "[network][newton]") {
  Model tight = water_model();
  tight.maximum_iterations = 6;
  FlowSetup hurried = dry_fracture(tight, 41), patient = dry_fracture(water_model(), 41);
  const AdvanceReport report = hurried.advance(10);
  CHECK(report.halvings > 0);
  CHECK(report.steps == report.halvings + 1);
  CHECK(report.newton.converged);
  CHECK(report.newton.residual <= tight.tolerance);
  CHECK(hurried.state.time == patient.state.time + 10);
  for (int k = 0; k < 100; ++k) patient.advance(0.1);
  CHECK(hurried.stored() == Approx(patient.stored()).epsilon(1e-14));
  CHECK(std::abs(ledger_report(hurried.model, hurried.graph, hurried.state).residual()) <= 1e-15);
}

TEST_CASE("Newton: an interval that no halving saves ends with times, node and residual",
          "[network][newton]") {
  Model hopeless = water_model();
  hopeless.maximum_iterations = 1;
  hopeless.tolerance = 1e-300;
  FlowSetup setup(hopeless, straight_fracture(5, 0.5, {0}));
  setup.model.schedule = constant_rate(1e-3);
  setup.set_rigid(1e-3);
  setup.interval.compliance.assign(5, 1e-9);
  setup.interval.reference_pressure.assign(5, 9e6);
  CHECK_THROWS_AS(setup.advance(10), SolverError);
}

TEST_CASE("Newton: the order of the nodes does not matter", "[network][newton]") {
  constexpr std::size_t count = 21;
  Insertion ordered = straight_fracture(count, 0.5, {10}), shuffled = ordered;
  std::vector<std::size_t> position(count);
  for (std::size_t i = 0; i < count; ++i) position[i] = (i * 8) % count;
  for (std::size_t i = 0; i < count; ++i) shuffled.new_nodes[position[i]] = ordered.new_nodes[i];
  std::reverse(shuffled.new_segments.begin(), shuffled.new_segments.end());
  Model model = water_model();
  model.schedule = constant_rate(1e-3);
  model.leak_off = {1e-5, 0};
  FlowSetup first(model, ordered), second(model, shuffled);
  for (int k = 0; k < 30; ++k) {
    for (std::size_t i = 0; i < count; ++i) {
      const double aperture = 1e-5 * (1 + k) * static_cast<double>(1 + (i * 5) % 13);
      first.interval.aperture[i] = second.interval.aperture[position[i]] = k == 0 && i != 10 ? 0 : aperture;
      first.interval.compliance[i] = second.interval.compliance[position[i]] = 1e-10;
      first.interval.reference_pressure[i] = second.interval.reference_pressure[position[i]] = 5e6;
    }
    first.advance(0.01);
    second.advance(0.01);
  }
  for (std::size_t i = 0; i < count; ++i) {
    // Both solve to the tolerance of Newton.
    CHECK(second.state.pressure[position[i]] == Approx(first.state.pressure[i]).epsilon(1e-7));
    CHECK(second.state.content[position[i]] == Approx(first.state.content[i]).epsilon(1e-7).margin(1e-14));
  }
}

TEST_CASE("Newton: a sealed fracture that closes without fluid stays regular", "[network][newton]") {
  FlowSetup setup(water_model(), straight_fracture(4, 0.5, {}));
  setup.interval.faces.assign(4, Faces::in_contact);
  setup.interval.reference_pressure.assign(4, 5e6);
  setup.interval.compliance.assign(4, 1e-10);
  setup.state.filled.assign(4, 1.0);
  setup.state.pressure.assign(4, 3e6);
  const AdvanceReport report = setup.advance(0.01);
  CHECK(report.newton.converged);
  CHECK(setup.stored() == 0);
}
