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

// The well, in steady flow to a basin without pressure.
namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 3.3";
constexpr double rate = 1e-4, flux = rate / water::thickness;
constexpr StillRock rigid{.aperture = 1e-4};
constexpr std::size_t segments = OpenSlit::nodes - 1;
/// A perforation that resists about as much as a segment of the slit, so that it is seen.
constexpr double narrow_well = 1e-10;

/// Of one segment [Pa s / m2].
double resistance() {
  return 12 * water::viscosity * OpenSlit::spacing / std::pow(rigid.aperture, 3);
}

Case narrow(Case run_case) {
  run_case.injection.well_index = narrow_well;
  return run_case;
}

Case held_at(double pressure) {
  Case run_case = narrow(water_case(rate));
  run_case.injection.stages.front() = {
      .begin = 0, .control = StageControl::pressure, .pressure = pressure, .fluid = "water"};
  return run_case;
}

std::string one_perforation(const Candidate& candidate) {
  OpenSlit slit(candidate, narrow(water_case(rate)), rigid);
  slit.settle();
  const double expected = flux / narrow_well + flux * resistance() * segments;
  require_ratio("well pressure [Pa]", slit.last.well_pressure, expected, solution_tolerance);
  require_ratio("well pressure less that of the perforated node [Pa]",
                slit.last.well_pressure - slit.last.pressure.front(), flux / narrow_well, solution_tolerance);
  return fmt::format("{:.7g} Pa, {:.7g} Pa by hand", slit.last.well_pressure, expected);
}

/// Two perforations, at the first and the fourth node of the way to the basin; each gets its share.
std::string two_perforations(const Candidate& candidate) {
  constexpr std::size_t second = 3;
  Insertion first = straight_slit(OpenSlit::nodes - 1, OpenSlit::spacing, 0);
  first.new_nodes[second].role = NodeRole::perforation;
  first.new_perforations.push_back({"well", first.new_nodes[second].id});
  StillScene scene(candidate, narrow(water_case(rate)), first, rigid);
  scene.advance(1e-6);
  scene.insert(basin(scene.driver.network(), OpenSlit::nodes - 2, OpenSlit::spacing, scene.time));
  scene.advance_many(10, 0.05);
  // q_1 (1 / WI + R between) = q_2 / WI,  q_1 + q_2 = q
  const double between = resistance() * second, by_way = 1 / narrow_well;
  const double upstream = flux * by_way / (2 * by_way + between);
  const double at_second = flux * resistance() * static_cast<double>(segments - second);
  require_ratio("drop of pressure from the first perforation to the second [Pa]",
                scene.last.pressure[0] - scene.last.pressure[second], upstream * between, solution_tolerance);
  require_ratio("pressure at the second perforation [Pa]", scene.last.pressure[second], at_second,
                solution_tolerance);
  require_ratio("well pressure [Pa]", scene.last.well_pressure, at_second + (flux - upstream) * by_way,
                solution_tolerance);
  require_injected(scene.last, rate * scene.time);
  require_balance(scene.driver, scene.last);
  return fmt::format("{:.4g} of the rate at the first, {:.4g} by hand; well {:.7g} Pa",
                     (scene.last.pressure[0] - scene.last.pressure[second]) / between / flux, upstream / flux,
                     scene.last.well_pressure);
}

std::string held_pressure(const Candidate& candidate) {
  constexpr double pressure = 2e6;
  OpenSlit slit(candidate, held_at(pressure), rigid);
  slit.settle();
  const double expected = water::thickness * pressure / (1 / narrow_well + resistance() * segments);
  require_ratio("well pressure [Pa]", slit.last.well_pressure, pressure, rounding);
  require_ratio("rate of the well [m3/s]", slit.last.rate, expected, solution_tolerance);
  const double before = slit.last.ledger.injected, begin = slit.time;
  slit.advance(0.05);
  require_ratio("injected in an interval of steady flow [m3]", slit.last.ledger.injected - before,
                expected * (slit.time - begin), solution_tolerance);
  require_balance(slit.driver, slit.last);
  return fmt::format("{:.7g} m3/s, {:.7g} m3/s by hand", slit.last.rate, expected);
}

/// A well held below the slit's pressure takes fluid out, and the ledger counts it as less injected.
std::string produces(const Candidate& candidate) {
  constexpr double high = 2e6, low = 5e5;
  Case run_case = held_at(high);
  run_case.injection.stages.push_back(
      {.begin = 0.4, .control = StageControl::pressure, .pressure = low, .fluid = "water"});
  constexpr std::size_t nodes = 5;
  StillScene scene(candidate, run_case, straight_slit(nodes, OpenSlit::spacing, 0), rigid);
  const auto volume = [&scene](double pressure) {
    return water::thickness * scene.length() * rigid.aperture * pressure / water::bulk_modulus;
  };
  scene.advance_many(8, 0.05);
  require_ratio("ledger.injected of a closed slit under the well's pressure [m3]", scene.last.ledger.injected,
                volume(high), solution_tolerance);
  scene.advance_many(6, 0.05);
  require_ratio("ledger.injected after it was let down [m3]", scene.last.ledger.injected, volume(low),
                10 * solution_tolerance);
  require_balance(scene.driver, scene.last);
  return fmt::format("{:.6g} m3, {:.6g} m3 by hand", scene.last.ledger.injected, volume(low));
}

/// No rate in all, but two perforations at different pressures exchange fluid through the well.
std::string exchange(const Candidate& candidate) {
  constexpr std::size_t nodes = 5;
  constexpr double reference = 1e6, compliance = 1e-10;
  Insertion first = straight_slit(nodes, OpenSlit::spacing, 0);
  first.new_nodes.back().role = NodeRole::perforation;
  first.new_perforations.push_back({"well", first.new_nodes.back().id});
  first.new_segments.erase(first.new_segments.begin() + 2);  // two slits, joined by the well alone
  StillScene scene(candidate, water_case(0), first, {.aperture = 1e-4, .compliance = compliance});
  // Full at the pressure of their references: west 1e6 Pa, east none.
  for (std::size_t i = 0; i < 3; ++i) scene.asked.reference_pressure[i] = reference;
  scene.advance_many(8, 100);
  const double pressure = scene.last.pressure.front();
  for (std::size_t i = 0; i < nodes; ++i)
    require_ratio(fmt::format("pressure of node {} [Pa]", i), scene.last.pressure[i], pressure,
                  solution_tolerance);
  require_ratio("well pressure [Pa]", scene.last.well_pressure, pressure, solution_tolerance);
  require_close("ledger.injected [m3]", scene.last.ledger.injected, 0,
                ledger_tolerance * scene.last.ledger.in_place);
  require_balance(scene.driver, scene.last);
  return fmt::format("both come to {:.6g} Pa through the well", pressure);
}

}  // namespace

std::vector<Check> well_checks() {
  const std::set<std::string> flow{claims::viscous_flow}, growth{"insert"};
  return {
      {.name = "well.one_perforation",
       .contract = contract,
       .expected = "the well stands q / WI above the perforated node",
       .physics = flow,
       .capabilities = growth,
       .carry_out = one_perforation},
      {.name = "well.two_perforations",
       .contract = contract,
       .expected = "perforations share one well pressure, and the rate by what resists behind them",
       .physics = flow,
       .capabilities = growth,
       .carry_out = two_perforations},
      {.name = "well.exchange",
       .contract = contract,
       .expected = "shut in, perforations exchange fluid until their pressures are one",
       .physics = flow,
       .carry_out = exchange},
      {.name = "well.held_pressure",
       .contract = contract,
       .expected = "a stage of given pressure pumps what the way to the basin lets through",
       .physics = {claims::viscous_flow, claims::pressure_control},
       .capabilities = growth,
       .carry_out = held_pressure},
      {.name = "well.produces",
       .contract = contract,
       .expected = "a well held below the slit takes back what it gave",
       .physics = {claims::pressure_control},
       .carry_out = produces},
  };
}

}  // namespace fissura::coupler::conformance
