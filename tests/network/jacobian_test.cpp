// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "network/assemble.hpp"
#include "tests/network/flow_setup.hpp"

using namespace fissura;
using namespace fissura::network;
using namespace fissura::network::test;

namespace {

/// A T of three branches with two perforations, in every condition a node can be in.
FlowSetup branched_fracture(const Schedule& schedule) {
  Insertion insertion = straight_fracture(6, 0.5, {1, 3});
  insertion.new_nodes.push_back({.id = 20, .x = 1, .y = 0.5, .lumped_length = 0.25});
  insertion.new_segments.push_back({.id = 20, .node_a = 20, .node_b = 3, .length = 0.5});
  for (const std::size_t natural : {0, 4, 6}) {
    insertion.new_nodes[natural].joint_compliance = 2e-11;
    insertion.new_nodes[natural].formation_pressure = 1e6;
  }
  insertion.new_segments.back().kind = SegmentKind::natural;
  Model model = water_model();
  model.schedule = schedule;
  model.leak_off = {1e-5, 0};
  FlowSetup setup(model, insertion);
  setup.state.contact_pressure[0] = 5e6;
  setup.state.contact_pressure[4] = 6e6;
  setup.interval.aperture = {1e-3, 8e-4, 5e-4, 1e-4, 0, 0, 2e-4};
  setup.interval.compliance = {1e-10, 2e-10, 0, 1e-9, 1e-10, 0, 1e-10};
  setup.interval.reference_pressure = {5e6, 5e6, 1e6, 3e6, 4e6, 0, 2e6};
  setup.interval.faces[4] = Faces::in_contact;
  return setup;
}

Assembly assembled(const FlowSetup& setup, const std::vector<double>& unknown) {
  Step step;
  State state = setup.state;
  if (!setup.model.schedule.stages().empty()) state.stage = 0;
  prepare_step(setup.model, setup.graph, setup.interval, state, 0.01, step);
  Assembly assembly;
  assemble(setup.model, setup.graph, step, setup.interval.aperture, unknown, assembly);
  return assembly;
}

}  // namespace

TEST_CASE(
    "Jacobian: equal to finite differences for wet, part-filled and dry nodes and both controls of the well",
    "[network][newton]") {
  for (const Schedule& schedule : {constant_rate(1e-3), constant_pressure(6e6)}) {
    const FlowSetup setup = branched_fracture(schedule);
    const std::vector<double> unknown{5.3, 5.1, 2.2, -0.4, 4.7, -2.5, 1.9, 6.2};
    const Assembly assembly = assembled(setup, unknown);
    const JacobianPattern& pattern = setup.graph.pattern();
    REQUIRE(unknown.size() == pattern.size());
    for (std::size_t column = 0; column < pattern.size(); ++column) {
      const double step = 1e-4;
      std::vector<double> above = unknown, below = unknown;
      above[column] += step;
      below[column] -= step;
      const Assembly up = assembled(setup, above), down = assembled(setup, below);
      std::vector<double> exact(pattern.size(), 0.0);
      double largest = 0;
      for (int entry = pattern.column_begin[column]; entry < pattern.column_begin[column + 1]; ++entry) {
        exact[pattern.row[entry]] = assembly.jacobian[entry];
        largest = std::max(largest, std::abs(assembly.jacobian[entry]));
      }
      for (std::size_t row = 0; row < pattern.size(); ++row) {
        CAPTURE(row, column);
        // Quadratic at most, so only rounding of the residual over the step is left.
        CHECK((up.residual[row] - down.residual[row]) / (2 * step) ==
              Approx(exact[row]).margin(1e-7 * largest));
      }
    }
  }
}

TEST_CASE("Jacobian: columns are diagonally dominant, so the diagonal may be kept as pivot",
          "[network][newton]") {
  for (const Schedule& schedule : {constant_rate(1e-3), constant_pressure(6e6)}) {
    const FlowSetup setup = branched_fracture(schedule);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-2, 8);
    for (int sample = 0; sample < 50; ++sample) {
      std::vector<double> unknown(setup.graph.pattern().size());
      for (double& u : unknown) u = any(random);
      const Assembly assembly = assembled(setup, unknown);
      const JacobianPattern& pattern = setup.graph.pattern();
      for (std::size_t column = 0; column < pattern.size(); ++column) {
        double diagonal = 0, others = 0;
        for (int entry = pattern.column_begin[column]; entry < pattern.column_begin[column + 1]; ++entry)
          (pattern.row[entry] == static_cast<int>(column) ? diagonal : others) +=
              std::abs(assembly.jacobian[entry]);
        CHECK(others <= diagonal * (1 + 1e-12));
      }
    }
  }
}
