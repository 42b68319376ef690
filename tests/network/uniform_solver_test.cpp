// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/uniform/uniform_solver.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/network/cell_setup.hpp"

using namespace fissura;
using namespace fissura::network::test;
using fissura::uniform_flow::UniformSolver;

TEST_CASE("uniform solver: the pressure is that of the volume in the springs around it",
          "[network][uniform]") {
  FlowCase pumped = water();
  pumped.stages = {from_the_start(WellControl::rate, 1e-4)};
  UniformSolver solver;
  CellSetup setup(solver, pumped, chain(9, 0.5, {4}));
  const double aperture = 3e-4, compliance = 1e-10, length = 4, modulus = 2e9;
  std::ranges::fill(setup.interval.aperture, aperture);
  std::ranges::fill(setup.interval.compliance, compliance);
  const FlowAnswer answer = setup.advance(2.0);
  // (a + C p) (1 + p / K) = a + volume / length
  const double square = compliance / modulus, linear = compliance + aperture / modulus;
  const double added = 2e-4 / length;
  const double expected = 2 * added / (linear + std::sqrt(linear * linear + 4 * square * added));
  for (const double pressure : answer.pressure) CHECK(pressure == Approx(expected).epsilon(1e-12));
  CHECK(answer.well_pressure == Approx(expected + 1e-4 / 1e-5).epsilon(1e-12));
  CHECK(std::abs(answer.ledger.residual()) < 1e-14 * answer.ledger.in_fractures);
}

TEST_CASE("uniform solver: parts that no segment joins share one well pressure, each by its own room",
          "[network][uniform]") {
  Insertion two = chain(5, 0.5, {1});
  for (NetworkNode node : chain(5, 1.0, {}).new_nodes) {
    node.id += 10;
    node.y = 5;
    two.new_nodes.push_back(node);
  }
  for (NetworkSegment segment : chain(5, 1.0, {}).new_segments) {
    segment.id += 10;
    segment.node_a += 10;
    segment.node_b += 10;
    two.new_segments.push_back(segment);
  }
  two.new_perforations.push_back({"second", 13});
  FlowCase pumped = water();
  pumped.stages = {from_the_start(WellControl::rate, 1e-4)};
  UniformSolver solver;
  CellSetup setup(solver, pumped, two);
  std::ranges::fill(setup.interval.aperture, 3e-4);
  std::ranges::fill(setup.interval.compliance, 1e-10);
  FlowAnswer answer;
  for (int k = 0; k < 3; ++k) answer = setup.advance(1.0);
  // The well is so good that it drops hardly any pressure: what flows goes where there is room.
  const double drop = answer.well_pressure - answer.pressure.front();
  CHECK(std::abs(answer.pressure.front() - answer.pressure.back()) <= 2 * drop);
  const auto content = setup.content();
  CHECK(content.front() == Approx(content.back()).epsilon(1e-4));
  CHECK(answer.ledger.injected == Approx(10 * 3e-4).epsilon(1e-14));
  CHECK(std::abs(answer.ledger.residual()) < 1e-14 * answer.ledger.in_fractures);
}

TEST_CASE("uniform solver: fluid that does not fill its fracture has no pressure", "[network][uniform]") {
  FlowCase drawn = water();
  drawn.stages = {from_the_start(WellControl::rate, -1e-4)};
  UniformSolver solver;
  CellSetup setup(solver, drawn, chain(9, 0.5, {4}));
  std::ranges::fill(setup.interval.aperture, 3e-4);
  std::ranges::fill(setup.interval.compliance, 1e-10);
  const FlowAnswer answer = setup.advance(6.0);
  // Half of 4 m times 0.3 mm is gone.
  for (std::size_t i = 0; i < answer.pressure.size(); ++i) {
    CHECK(answer.pressure[i] == 0);
    CHECK(answer.filled[i] == Approx(0.5).epsilon(1e-12));
  }
}
