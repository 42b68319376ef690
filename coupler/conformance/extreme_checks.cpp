// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coupler/conformance/balance.hpp"
#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/physics_checks.hpp"
#include "coupler/conformance/still_rock.hpp"
#include "coupler/conformance/topologies.hpp"

// Sizes that runs come to: the same laws, and the same balances.
namespace fissura::coupler::conformance {

namespace {

constexpr std::size_t nodes = 5;
constexpr double spacing = 0.5;
constexpr double length = spacing * (nodes - 1);

/// Pumped until `end` at a rate that brings `share` of the content at the start, then at rest under the
/// pressure of (3c).
std::string at_rest(const Candidate& candidate, const StillRock& rock, double share, double conducting) {
  constexpr double end = 0.01;
  const double rate = share * rock.aperture * length * water::thickness / end;
  StillScene scene(candidate, puff(rate, end), straight_slit(nodes, spacing, nodes / 2), rock);
  scene.advance(end);
  require_injected(scene.last, rate * end);
  require_balance(scene.driver, scene.last);
  scene.come_to_rest(conducting);
  require_balance(scene.driver, scene.last);
  const double expected = rock.pressure_of((1 + share) * rock.aperture, water::bulk_modulus);
  for (std::size_t i = 0; i < nodes; ++i)
    require_ratio(fmt::format("pressure of node {} [Pa]", i), scene.last.pressure[i], expected,
                  solution_tolerance);
  return fmt::format("{:.7g} Pa, {:.7g} Pa by hand", scene.last.pressure.front(), expected);
}

std::string wide(const Candidate& candidate) {
  return at_rest(candidate, {.aperture = 1e-2, .compliance = 1e-9}, 0.1, 1e-2);
}

/// The floor of the conductance lets the fluid pass.
std::string narrow(const Candidate& candidate) {
  return at_rest(candidate, {.aperture = 1e-8, .compliance = 1e-12}, 20, 1e-5);
}

std::string high_pressure(const Candidate& candidate) {
  return at_rest(candidate, {.aperture = 1e-4}, 0.2, 1e-4);
}

/// Ten thousand times as wide as the node beside it: at rest all stand under one pressure.
std::string side_by_side(const Candidate& candidate) {
  constexpr double narrow_aperture = 1e-6, wide_aperture = 1e-2, end = 0.01, rate = 0.05;
  StillScene scene(candidate, puff(rate, end), straight_slit(nodes, spacing, nodes / 2),
                   {.aperture = narrow_aperture, .compliance = 1e-9});
  for (std::size_t i = 0; i < nodes; i += 2) scene.asked.aperture[i] = wide_aperture;
  const double mean = integral(scene.driver.network(), scene.asked.aperture) / length;
  scene.advance(end);
  require_balance(scene.driver, scene.last);
  scene.come_to_rest(wide_aperture / 2);
  const StillRock as_one{.aperture = mean, .compliance = scene.rock.compliance};
  const double expected =
      as_one.pressure_of(mean + rate * end / (water::thickness * length), water::bulk_modulus);
  for (std::size_t i = 0; i < nodes; ++i)
    require_ratio(fmt::format("pressure of node {} [Pa]", i), scene.last.pressure[i], expected,
                  solution_tolerance);
  require_balance(scene.driver, scene.last);
  return fmt::format("{:.7g} Pa, {:.7g} Pa by hand", scene.last.pressure.front(), expected);
}

constexpr StillRock soft{.aperture = 1e-4, .compliance = 1e-10};

/// A drop each second: the sum is not lost beside what is in place.
std::string little(const Candidate& candidate) {
  constexpr double rate = 1e-15;
  StillScene scene(candidate, water_case(rate), straight_slit(nodes, spacing, nodes / 2), soft);
  scene.advance_many(10, 1);
  require_injected(scene.last, rate * scene.time);
  require_closed(scene.last.ledger);
  return fmt::format("{:.6g} m3 at {:g} m3/s beside {:.4g} m3 in place", scene.last.ledger.injected, rate,
                     scene.last.ledger.in_place);
}

std::string short_intervals(const Candidate& candidate) {
  constexpr double rate = 2e-4;
  StillScene scene(candidate, water_case(rate), straight_slit(nodes, spacing, nodes / 2), soft);
  double before = -1;
  for (int k = 0; k < 20; ++k) {
    scene.advance(1e-9);
    require_injected(scene.last, rate * scene.time);
    require_balance(scene.driver, scene.last);
    require(scene.last.pressure[nodes / 2] > before, "a pressure at the well that rises in every interval",
            fmt::format("{:g} Pa after {:g} Pa", scene.last.pressure[nodes / 2], before));
    before = scene.last.pressure[nodes / 2];
  }
  return fmt::format("{:.6g} m3 in {:g} s", scene.last.ledger.injected, scene.time);
}

/// An interval of ten thousand time constants of the slit, after one in which much was pumped.
std::string long_interval(const Candidate& candidate) {
  constexpr double rate = 2e-4, end = 1;
  StillScene scene(candidate, puff(rate, end), straight_slit(nodes, spacing, nodes / 2), soft);
  scene.advance(end);
  scene.advance(2000);
  const double expected =
      soft.pressure_of(soft.aperture + rate * end / (water::thickness * length), water::bulk_modulus);
  // One step of backward Euler leaves a ten-thousandth of the differences.
  for (std::size_t i = 0; i < nodes; ++i)
    require_ratio(fmt::format("pressure of node {} [Pa]", i), scene.last.pressure[i], expected, 1e-3);
  require_injected(scene.last, rate * end);
  require_balance(scene.driver, scene.last);
  return fmt::format("{:.6g} Pa, {:.6g} Pa by hand", scene.last.pressure.front(), expected);
}

}  // namespace

std::vector<Check> extreme_checks() {
  constexpr const char *content = "flow_solvers.md 3.1", *interval = "flow_solvers.md 3";
  return {
      {.name = "extreme.wide",
       .contract = content,
       .expected = "faces a centimetre apart stand under the pressure of (3c)",
       .carry_out = wide},
      {.name = "extreme.narrow",
       .contract = content,
       .expected = "faces ten nanometres apart, which take twenty times their content, too",
       .carry_out = narrow},
      {.name = "extreme.high_pressure",
       .contract = content,
       .expected = "fluid in a rigid slit that is pressed together by a sixth, too",
       .carry_out = high_pressure},
      {.name = "extreme.side_by_side",
       .contract = content,
       .expected = "a micrometre beside a centimetre come to one pressure",
       .carry_out = side_by_side},
      {.name = "extreme.little",
       .contract = "flow_solvers.md 4",
       .expected = "a rate of a cubic micrometre a millisecond is counted",
       .carry_out = little},
      {.name = "extreme.short_intervals",
       .contract = interval,
       .expected = "intervals of a nanosecond raise the pressure and are counted",
       .carry_out = short_intervals},
      {.name = "extreme.long_interval",
       .contract = interval,
       .expected = "an interval far longer than the fluid's memory ends at rest",
       .carry_out = long_interval},
  };
}

}  // namespace fissura::coupler::conformance
