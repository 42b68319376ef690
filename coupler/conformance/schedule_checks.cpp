// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "coupler/conformance/balance.hpp"
#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/physics_checks.hpp"
#include "coupler/conformance/still_rock.hpp"
#include "coupler/conformance/topologies.hpp"

// Volumes that a schedule injects: integrals of a target that is linear by pieces, exact in any steps.
namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 3.3";
constexpr std::size_t nodes = 7;
constexpr double spacing = 0.5, rate = 2e-4;
constexpr StillRock soft{.aperture = 1e-4, .compliance = 1e-10};

Case without_stages() {
  Case run_case = water_case(rate);
  run_case.injection.stages.clear();
  return run_case;
}

StillScene scene_of(const Candidate& candidate, const Case& run_case) {
  return {candidate, run_case, straight_slit(nodes, spacing, nodes / 2), soft};
}

void require_rate(const FlowAnswer& answer, double expected, double scale) {
  require_close("rate of the well at the end of the interval [m3/s]", answer.rate, expected,
                rounding * scale);
}

std::string constant(const Candidate& candidate) {
  StillScene scene = scene_of(candidate, water_case(rate));
  for (const double duration : {0.1, 0.003, 0.25, 0.1}) {
    scene.advance(duration);
    require_injected(scene.last, rate * scene.time);
    require_rate(scene.last, rate, rate);
    require_balance(scene.driver, scene.last);
  }
  return fmt::format("{:.9g} m3 in {:g} s at {:g} m3/s", scene.last.ledger.injected, scene.time, rate);
}

std::string several(const Candidate& candidate) {
  Case run_case = without_stages();
  add_stage(run_case, 0, rate);
  add_stage(run_case, 0.2, 3 * rate);
  add_stage(run_case, 0.3, 0);
  add_stage(run_case, 0.5, rate / 2);
  StillScene scene = scene_of(candidate, run_case);
  const double rates[] = {rate, rate, 3 * rate, 0, 0, rate / 2};
  const double ends[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  double volume = 0;
  for (std::size_t k = 0; k < std::size(rates); ++k) {
    volume += rates[k] * (ends[k] - scene.time);
    scene.advance(ends[k] - scene.time);
    require_injected(scene.last, volume);
    require_balance(scene.driver, scene.last);
  }
  return fmt::format("{:.9g} m3 through four stages, {:.9g} m3 by hand", scene.last.ledger.injected, volume);
}

std::string inside_an_interval(const Candidate& candidate) {
  constexpr double change = 0.37;
  Case run_case = water_case(rate);
  add_stage(run_case, change, 4 * rate);
  StillScene scene = scene_of(candidate, run_case);
  scene.advance_many(2, 0.3);
  const double volume = rate * change + 4 * rate * (scene.time - change);
  require_injected(scene.last, volume);
  require_rate(scene.last, 4 * rate, rate);
  require_balance(scene.driver, scene.last);
  return fmt::format("{:.9g} m3, {:.9g} m3 by hand", scene.last.ledger.injected, volume);
}

std::string before_the_first(const Candidate& candidate) {
  Case run_case = without_stages();
  add_stage(run_case, 0.25, rate);
  StillScene scene = scene_of(candidate, run_case);
  scene.advance_many(2, 0.1);
  require_close("ledger.injected before the first stage [m3]", scene.last.ledger.injected, 0,
                rounding * rate);
  require_rate(scene.last, 0, rate);
  for (const double pressure : scene.last.pressure)
    require_close("pressure before the first stage [Pa]", pressure, 0, 1e-3);
  scene.advance_many(2, 0.1);
  require_injected(scene.last, rate * (scene.time - 0.25));
  return fmt::format("nothing until 0.25 s, {:.6g} m3 until {:g} s", scene.last.ledger.injected, scene.time);
}

/// Up from nothing, on a level, down to another level; the intervals do not end where the ramps do.
std::string ramp(const Candidate& candidate) {
  constexpr double up = 0.5, second = 0.8, down = 0.4, lower = rate / 4;
  Case run_case = without_stages();
  add_stage(run_case, 0, rate);
  run_case.injection.stages.back().ramp = up;
  add_stage(run_case, second, lower);
  run_case.injection.stages.back().ramp = down;
  const auto target = [](double t) {
    if (t < up) return rate * t / up;
    if (t < second) return rate;
    return t < second + down ? rate + (lower - rate) * (t - second) / down : lower;
  };
  const double corners[] = {0, up, second, second + down, 10};
  const auto volume = [&](double t) {
    double sum = 0;  // the trapezium of each straight piece
    for (std::size_t k = 0; k + 1 < std::size(corners) && corners[k] < t; ++k) {
      const double end = std::min(t, corners[k + 1]);
      sum += 0.5 * (target(corners[k]) + target(end)) * (end - corners[k]);
    }
    return sum;
  };
  StillScene scene = scene_of(candidate, run_case);
  for (int k = 0; k < 11; ++k) {
    scene.advance(0.13);
    require_injected(scene.last, volume(scene.time));
    require_rate(scene.last, target(scene.time), rate);
    require_balance(scene.driver, scene.last);
  }
  return fmt::format("{:.9g} m3 over two ramps, {:.9g} m3 by hand", scene.last.ledger.injected,
                     volume(scene.time));
}

std::string shut_in(const Candidate& candidate) {
  constexpr double end = 0.2, long_time = 60;
  Case run_case = water_case(rate);
  add_stage(run_case, end, 0);
  StillScene scene = scene_of(candidate, run_case);
  scene.advance_many(2, end / 2);
  const FluidLedger before = scene.last.ledger;
  scene.advance(0.01);
  require_rate(scene.last, 0, rate);
  require_injected(scene.last, before.injected);
  scene.advance_many(6, long_time);
  require_injected(scene.last, before.injected);
  require_ratio("ledger.in_fractures [m3]", scene.last.ledger.in_fractures, before.in_fractures, rounding);
  require_balance(scene.driver, scene.last);
  const double content = soft.aperture + rate * end / (water::thickness * scene.length());
  const double expected = soft.pressure_of(content, water::bulk_modulus);
  for (const double pressure : scene.last.pressure)
    require_ratio("pressure that all nodes come to [Pa]", pressure, expected, solution_tolerance);
  require_ratio("well pressure at rest [Pa]", scene.last.well_pressure, expected, solution_tolerance);
  return fmt::format("rate 0 at once, {:.7g} Pa everywhere, {:.7g} Pa by hand", scene.last.pressure.front(),
                     expected);
}

/// Per unit thickness both runs are the same.
std::string thickness(const Candidate& candidate) {
  constexpr double factor = 2;
  Case thick_case = water_case(factor * rate);
  thick_case.domain.thickness = factor * water::thickness;
  StillScene thin = scene_of(candidate, water_case(rate)), thick = scene_of(candidate, thick_case);
  for (int k = 0; k < 4; ++k) {
    thin.advance(0.1);
    thick.advance(0.1);
    for (std::size_t i = 0; i < nodes; ++i)
      require_ratio(fmt::format("pressure of node {} in twice the thickness [Pa]", i), thick.last.pressure[i],
                    thin.last.pressure[i], 1e-9);
    require_ratio("ledger.injected in twice the thickness [m3]", thick.last.ledger.injected,
                  factor * thin.last.ledger.injected, rounding);
    require_ratio("ledger.in_place in twice the thickness [m3]", thick.last.ledger.in_place,
                  factor * thin.last.ledger.in_place, rounding);
    require_ratio("ledger.in_fractures in twice the thickness [m3]", thick.last.ledger.in_fractures,
                  factor * thin.last.ledger.in_fractures, rounding);
  }
  return fmt::format("{:.6g} m3 and {:.6g} m3 injected, {:.6g} Pa and {:.6g} Pa", thin.last.ledger.injected,
                     thick.last.ledger.injected, thin.last.pressure.front(), thick.last.pressure.front());
}

}  // namespace

std::vector<Check> schedule_checks() {
  return {
      {.name = "schedule.constant",
       .contract = contract,
       .expected = "a constant rate injects rate times time, whatever the intervals, and is told",
       .carry_out = constant},
      {.name = "schedule.several",
       .contract = contract,
       .expected = "each stage is in force from its begin until the next one's",
       .carry_out = several},
      {.name = "schedule.inside_an_interval",
       .contract = contract,
       .expected = "a stage that begins inside an interval is in force from there",
       .carry_out = inside_an_interval},
      {.name = "schedule.before_the_first",
       .contract = contract,
       .expected = "nothing is pumped before the first stage",
       .carry_out = before_the_first},
      {.name = "schedule.ramp",
       .contract = contract,
       .expected = "ramps inject the integral of their target, from what the well did before",
       .carry_out = ramp},
      {.name = "schedule.shut_in",
       .contract = contract,
       .expected = "the rate is 0 at once, the volume is kept, all pressures become that of (3c)",
       .carry_out = shut_in},
      {.name = "schedule.thickness",
       .contract = contract,
       .expected = "twice the thickness at twice the rate: the same pressures, twice the volumes",
       .carry_out = thickness},
  };
}

}  // namespace fissura::coupler::conformance
