// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "common/coupling/coupling_clock.hpp"
#include "common/coupling/displacement_discontinuity.hpp"
#include "common/coupling/interface_compliance.hpp"
#include "common/coupling/pressure_ramp.hpp"

using namespace fissura;

namespace {

constexpr double modulus = 33.3333e9;

/// A chain of nodes through `points`, each with half of its adjoining segments (a whole one at the ends).
void add_chain(Insertion& insertion, const std::vector<std::array<double, 2>>& points) {
  const NodeId base = insertion.new_nodes.size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    NetworkNode node;
    node.id = base + i;
    node.x = points[i][0];
    node.y = points[i][1];
    const std::size_t other = i + 1 < points.size() ? i + 1 : i - 1;
    node.lumped_length = std::hypot(points[other][0] - node.x, points[other][1] - node.y);
    insertion.new_nodes.push_back(node);
    if (i == 0) continue;
    const double length = std::hypot(points[i][0] - points[i - 1][0], points[i][1] - points[i - 1][1]);
    insertion.new_segments.push_back(
        {insertion.new_segments.size(), base + i - 1, base + i, 0, SegmentKind::hydraulic, length});
  }
}

FractureNetwork network_of(const Insertion& insertion) {
  FractureNetwork network;
  network.apply(insertion);
  return network;
}

std::vector<std::array<double, 2>> straight(double angle, int nodes, double spacing) {
  std::vector<std::array<double, 2>> points;
  for (int i = 0; i < nodes; ++i) {
    const double s = spacing * i;
    points.push_back({s * std::cos(angle), s * std::sin(angle)});
  }
  return points;
}

}  // namespace

TEST_CASE("the applied pressure starts from what was applied before", "[common][coupling]") {
  // The printed sign of Eq. (22) would start at 2 p_i - p_e instead.
  const PressureRamp ramp{4e6, 7e6, 1e-3, 1.2e-3, 2e9};
  CHECK(ramp.applied(0, 1e-3) == 4e6);
  CHECK(ramp.applied(1, 1.2e-3) == 7e6);
  CHECK(ramp.interpolated(0.25) == Approx(4.75e6).epsilon(1e-14));
}

TEST_CASE("opening beyond the prediction lowers the pressure by all of it since the coupling time",
          "[common][coupling]") {
  // Eq. (20) read per step would forget what opened in the steps before.
  const PressureRamp ramp{4e6, 4e6, 1e-3, 1e-3, 2e9};
  CHECK(ramp.applied(0.1, 1e-3 + 1e-5) == Approx(4e6 - 2e4).epsilon(1e-12));
  CHECK(ramp.applied(0.9, 1e-3 + 9e-5) == Approx(4e6 - 18e4).epsilon(1e-12));
  CHECK(ramp.applied(0.9, 1e-3 + 9e-2) == 0);
}

TEST_CASE("coupling times are hit exactly and never accumulate", "[common][coupling]") {
  CouplingClock clock(1.0);
  int intervals = 0;
  while (!clock.finished()) {
    const double must_hit = clock.time() < 0.3 ? 0.3 : 1.0;
    const ClockInterval interval = clock.next(0.07, must_hit);
    CHECK(interval.begin == clock.time());
    CHECK(interval.duration() <= 0.07 * 1.1);
    CHECK(interval.duration() >= 0.07 * 0.1);
    clock.commit(interval);
    ++intervals;
    if (interval.end > 0.3 && interval.begin < 0.3) FAIL("0.3 was missed");
  }
  CHECK(clock.time() == 1.0);
  CHECK(clock.index() == static_cast<std::uint64_t>(intervals));
}

TEST_CASE("one straight fracture takes Sneddon's opening", "[common][coupling]") {
  constexpr double spacing = 0.5;
  constexpr int nodes = 39;
  Insertion insertion;
  add_chain(insertion, straight(0.7, nodes, spacing));
  const std::vector<double> compliance = interface_compliance(network_of(insertion), modulus, 1);
  const double half_length = spacing * nodes / 2;
  CHECK(compliance[nodes / 2] == Approx(4 * half_length / modulus).epsilon(1e-3));
  CHECK(compliance[0] == Approx(compliance[nodes - 1]).epsilon(1e-9));
  for (const double value : interface_compliance(network_of(insertion), modulus, 1e-3))
    CHECK(value == Approx(compliance_floor(spacing, modulus)).epsilon(1e-9));
}

TEST_CASE("the displacement-discontinuity row sum of a straight crack is Sneddon's opening", "[common][coupling]") {
  constexpr int count = 80;
  constexpr double half_length = 10, cell = 2 * half_length / count;
  std::vector<DiscontinuityElement> elements;
  for (int i = 0; i < count; ++i) {
    const double s = -half_length + (i + 0.5) * cell;
    elements.push_back({0.6 * s, 0.8 * s, 0.6, 0.8, cell / 2});
  }
  const std::vector<double> opening = opening_under_unit_pressure(elements, modulus);
  // Constant elements overestimate by about a quarter of a cell of length; away from the tips that is 1 %.
  for (int i = 5; i < count - 5; ++i) {
    const double s = -half_length + (i + 0.5) * cell;
    CHECK(opening[static_cast<std::size_t>(i)] ==
          Approx(4 / modulus * std::sqrt(half_length * half_length - s * s)).epsilon(0.03));
  }
  CHECK(opening[count / 2] == Approx(4 * half_length / modulus).epsilon(0.01));
}

TEST_CASE("two far cracks do not feel each other, two close ones shield each other", "[common][coupling]") {
  const auto centre_opening = [](double distance) {
    std::vector<DiscontinuityElement> elements;
    for (int i = 0; i < 20; ++i)
      for (const double y : {0.0, distance}) elements.push_back({i * 0.5, y, 1, 0, 0.25});
    return opening_under_unit_pressure(elements, modulus)[20];
  };
  const double alone = centre_opening(1e6);
  CHECK(centre_opening(1e3) == Approx(alone).epsilon(1e-3));
  CHECK(centre_opening(2) < 0.7 * alone);
}

TEST_CASE("compliance is positive at bends and junctions and never below its floor", "[common][coupling]") {
  Insertion insertion;
  add_chain(insertion, straight(0, 21, 0.5));
  const double angle = GENERATE(15.0, 30.0, 60.0, 90.0, 120.0) * std::numbers::pi / 180;
  auto branch = straight(angle, 11, 0.5);
  branch.erase(branch.begin());
  for (auto& point : branch) point[0] += 5;
  add_chain(insertion, branch);
  insertion.new_segments.push_back({100, 10, 21, 0, SegmentKind::natural, 0.5});
  const FractureNetwork network = network_of(insertion);
  const std::vector<double> compliance = interface_compliance(network, modulus, 1);
  for (std::size_t i = 0; i < compliance.size(); ++i)
    CHECK(compliance[i] >= compliance_floor(network.nodes()[i].lumped_length, modulus));
  CHECK(compliance[5] > 10 * compliance_floor(0.5, modulus));
}

TEST_CASE("separate fractures have their own compliance", "[common][coupling]") {
  Insertion insertion;
  add_chain(insertion, straight(0, 11, 0.5));
  const double alone = interface_compliance(network_of(insertion), modulus, 1)[5];
  auto far = straight(1, 5, 0.5);
  for (auto& point : far) point[1] += 1000;
  add_chain(insertion, far);
  CHECK(interface_compliance(network_of(insertion), modulus, 1)[5] == alone);
}
