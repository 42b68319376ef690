// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "coupler/conformance/driver.hpp"
#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/pumped_slit.hpp"
#include "coupler/conformance/topologies.hpp"

namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 5";

/// The ledger closes to this share of the largest volume in it (flow_solvers.md 4).
constexpr double ledger_tolerance = 1e-10;
/// Content follows from the pressures only as well as the equations of the interval were solved.
constexpr double solution_tolerance = 1e-6;
/// Fields and their sum are formed in another order by everybody.
constexpr double rounding = 1e-12;

using MakeInsertion = std::function<Insertion(const FractureNetwork&, double time)>;

void require_balance(const FluidLedger& ledger) {
  const double largest = std::max(
      {std::abs(ledger.injected), ledger.in_place, ledger.found, ledger.in_fractures, ledger.leaked});
  require_close("ledger.residual", ledger.residual(), 0, ledger_tolerance * largest);
}

/// What the fields say is in the fractures [m3]; nothing if the solver does not tell.
std::optional<double> told_content(Driver& driver) {
  const std::optional<std::vector<double>> content = driver.report().find("content");
  if (!content) return std::nullopt;
  return water::thickness * integral(driver.network(), *content);
}

/// Pumps, inserts, pumps on: nothing is lost, nothing is made.
std::string conserves(const Candidate& candidate, const MakeInsertion& make) {
  PumpedSlit scene(candidate);
  scene.advance_many(4);
  const FluidLedger before = scene.last.ledger;
  const std::optional<double> told_before = told_content(scene.driver);
  scene.driver.insert(make(scene.driver.network(), scene.time));
  const std::optional<double> told_after = told_content(scene.driver);
  if (told_before && told_after)
    require_ratio("content of all nodes in FIELDS after the insertion [m3]", *told_after, *told_before,
                  rounding);

  for (int k = 0; k < 3; ++k) {
    const double pumped = PumpedSlit::rate * scene.time;
    scene.advance();
    const FluidLedger& now = scene.last.ledger;
    require_balance(now);
    require_ratio("ledger.injected [m3]", now.injected, pumped + PumpedSlit::rate * PumpedSlit::duration,
                  1e-9);
    require_ratio("ledger.in_place [m3]", now.in_place, before.in_place, rounding);
    require_ratio(
        "ledger.in_fractures [m3] as the pressures have it", now.in_fractures,
        water::thickness * integral(scene.driver.network(), content_of(scene.last, water::bulk_modulus)),
        solution_tolerance);
  }
  return fmt::format("revision {} acknowledged with the right hash; residual {:.1e} m3 of {:.3g} m3",
                     scene.driver.network().revision(), scene.last.ledger.residual(),
                     scene.last.ledger.injected);
}

Check conserving(const std::string& name, const std::string& what, const MakeInsertion& make) {
  return {.name = "insertion." + name,
          .contract = contract,
          .expected = what + ": the hash of the new network is acknowledged, the fluid is what it was",
          .carry_out = [make](const Candidate& candidate) { return conserves(candidate, make); }};
}

std::string new_node_is_dry(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance_many(4);
  scene.driver.insert(tip_growth(scene.driver.network(), PumpedSlit::spacing, scene.time));
  const std::size_t added = scene.driver.network().nodes().size() - 1;
  const ReportedFields fields = scene.driver.report();
  std::string told;
  for (const char* field : {"content", "pressure", "filled"}) {
    const std::optional<std::vector<double>> values = fields.find(field);
    if (!values) continue;
    require(values->size() > added, fmt::format("{} of {} nodes in FIELDS", field, added + 1),
            fmt::format("{}", values->size()));
    require_close(fmt::format("{} of the new node in FIELDS", field), values->at(added), 0, 0);
    told += fmt::format("{}{} 0", told.empty() ? "" : ", ", field);
  }
  return told.empty() ? "FIELDS does not tell" : told;
}

/// The arms to a new node are so narrow that an interval hardly brings it anything.
std::string new_node_fills_by_flow(const Candidate& candidate) {
  constexpr double narrow = 1e-5, short_time = 1e-3, nearly_dry = 0.05;
  PumpedSlit scene(candidate);
  scene.advance_many(4);
  scene.driver.insert(tip_growth(scene.driver.network(), PumpedSlit::spacing, scene.time));
  const std::size_t added = scene.driver.network().nodes().size() - 1;
  CouplingInterval interval = scene.next(short_time);
  const std::size_t segments = scene.driver.network().segments().size();
  interval.arm_aperture_a.assign(segments, 1e-4);
  interval.arm_aperture_b.assign(segments, 1e-4);
  interval.arm_aperture_a.back() = interval.arm_aperture_b.back() = narrow;
  const FlowAnswer answer = scene.driver.advance(interval);
  require_within("filled of the new node", answer.filled[added], 0, nearly_dry);
  require_close("pressure of the new node", answer.pressure[added], 0, 0);
  return fmt::format("filled {:.2g}, pressure {:g} Pa after {:g} s behind an arm of 10 um",
                     answer.filled[added], answer.pressure[added], short_time);
}

/// A slit at rest: pumped, shut in, evened out.
void come_to_rest(PumpedSlit& scene) {
  scene.advance_many(4);
  for (int k = 0; k < 6; ++k) scene.advance(50);
}

Case shut_in_case() {
  Case run_case = pumped_case();
  add_stage(run_case, 4 * PumpedSlit::duration, 0);
  return run_case;
}

/// Nodes that give length to a new one give the fluid on it, too: a slit at rest stays at rest.
std::string split_at_rest(const Candidate& candidate) {
  PumpedSlit scene(candidate, shut_in_case(),
                   straight_slit(PumpedSlit::nodes, PumpedSlit::spacing, PumpedSlit::nodes / 2));
  come_to_rest(scene);
  const double pressure = scene.last.pressure.front();
  require(pressure > 0, "a pressure in the slit at rest", fmt::format("{:g} Pa", pressure));
  constexpr double at_rest = 1e-4;
  for (const double each : scene.last.pressure)
    require_ratio("pressure at rest [Pa]", each, pressure, at_rest);
  scene.driver.insert(split_segment(scene.driver.network(), 2, scene.time));
  // The rock between two nodes is open as at both of them.
  scene.last.pressure.push_back(pressure);
  scene.advance(PumpedSlit::duration);
  constexpr double still_at_rest = 1e-3;
  for (std::size_t i = 0; i < scene.last.pressure.size(); ++i)
    require_ratio(fmt::format("pressure of node {} after the split [Pa]", i), scene.last.pressure[i],
                  pressure, still_at_rest);
  require_balance(scene.last.ledger);
  return fmt::format("{:.4g} Pa before, {:.4g} to {:.4g} Pa after", pressure,
                     *std::min_element(scene.last.pressure.begin(), scene.last.pressure.end()),
                     *std::max_element(scene.last.pressure.begin(), scene.last.pressure.end()));
}

/// Only lengths change: the same fluid on a longer node stands lower.
std::string updated_lengths(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance_many(4);
  const FluidLedger before = scene.last.ledger;
  Insertion insertion;
  insertion.revision = 1;
  constexpr std::size_t shorter = 2, longer = 6;
  for (const auto& [index, change] : {std::pair{shorter, -0.1}, {longer, 0.2}}) {
    NetworkNode node = scene.driver.network().nodes()[index];
    node.lumped_length += change;
    insertion.updated_nodes.push_back(node);
  }
  scene.driver.insert(insertion);
  scene.advance();
  require_balance(scene.last.ledger);
  require_ratio("ledger.in_fractures [m3]", scene.last.ledger.in_fractures,
                before.in_fractures + PumpedSlit::rate * PumpedSlit::duration, 1e-9);
  require_ratio(
      "ledger.in_fractures [m3] as the pressures have it", scene.last.ledger.in_fractures,
      water::thickness * integral(scene.driver.network(), content_of(scene.last, water::bulk_modulus)),
      solution_tolerance);
  return fmt::format("{:.6g} m3 before, {:.6g} m3 after, {:.6g} m3 pumped between", before.in_fractures,
                     scene.last.ledger.in_fractures, PumpedSlit::rate * PumpedSlit::duration);
}

/// Pore fluid that a natural fracture brings along is found, not injected.
std::string finds_pore_fluid(const Candidate& candidate) {
  constexpr double formation_pressure = 2e5;
  constexpr std::size_t length = 3;
  PumpedSlit scene(candidate);
  scene.advance_many(4);
  scene.driver.insert(natural_branch(scene.driver.network(), 2, length, PumpedSlit::spacing,
                                     formation_pressure, 0, scene.time));
  scene.last.pressure.resize(PumpedSlit::nodes + length, formation_pressure);
  const CouplingInterval interval = scene.next(PumpedSlit::duration);
  double expected = 0;
  for (std::size_t i = PumpedSlit::nodes; i < PumpedSlit::nodes + length; ++i)
    expected += water::thickness * scene.driver.network().nodes()[i].lumped_length * interval.aperture[i] *
                (1 + formation_pressure / water::bulk_modulus);
  scene.advance();
  require_ratio("ledger.found [m3]", scene.last.ledger.found, expected, rounding);
  require_balance(scene.last.ledger);
  scene.advance();
  require_ratio("ledger.found an interval later [m3]", scene.last.ledger.found, expected, rounding);
  return fmt::format("{:.6g} m3 found in {} nodes, {:.6g} m3 expected", scene.last.ledger.found, length,
                     expected);
}

/// l v is moved with the fluid: the book of leak-off goes on through a growth, a split and an arm.
std::string keeps_leaked_volume(const Candidate& candidate) {
  constexpr double coefficient = 1e-6;
  Case run_case = pumped_case();
  run_case.leak_off.coefficient = coefficient;
  PumpedSlit scene(candidate, run_case,
                   straight_slit(PumpedSlit::nodes, PumpedSlit::spacing, PumpedSlit::nodes / 2));
  const MakeInsertion insertions[] = {
      [](const FractureNetwork& network, double time) {
        return tip_growth(network, PumpedSlit::spacing, time);
      },
      [](const FractureNetwork& network, double time) { return split_segment(network, 5, time); },
      [](const FractureNetwork& network, double time) {
        return junction(network, 2, 2, PumpedSlit::spacing, time);
      }};
  for (const MakeInsertion& make : insertions) {
    scene.advance_many(2);
    const double before = scene.last.ledger.leaked;
    scene.driver.insert(make(scene.driver.network(), scene.time));
    scene.advance();
    require_balance(scene.last.ledger);
    // Never more than Carter asks of faces that were all exposed at time 0.
    const double length =
        integral(scene.driver.network(), std::vector<double>(scene.last.pressure.size(), 1.0));
    require_within("ledger.leaked [m3]", scene.last.ledger.leaked, before,
                   water::thickness * length * 4 * coefficient * std::sqrt(scene.time));
  }
  return fmt::format("{:.4g} m3 leaked, residual {:.1e} m3", scene.last.ledger.leaked,
                     scene.last.ledger.residual());
}

std::string grows_many_times(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  constexpr int insertions = 20;
  for (int k = 0; k < insertions; ++k) {
    scene.advance();
    scene.driver.insert(tip_growth(scene.driver.network(), PumpedSlit::spacing, scene.time));
  }
  scene.advance();
  require_balance(scene.last.ledger);
  require_ratio("ledger.injected [m3]", scene.last.ledger.injected, PumpedSlit::rate * scene.time, 1e-9);
  return fmt::format("{} insertions, residual {:.1e} m3 of {:.3g} m3", insertions,
                     scene.last.ledger.residual(), scene.last.ledger.injected);
}

}  // namespace

std::vector<Check> insertion_checks() {
  constexpr double spacing = PumpedSlit::spacing;
  return {
      conserving(
          "tip_growth", "one node beyond a tip",
          [](const FractureNetwork& network, double time) { return tip_growth(network, spacing, time); }),
      conserving(
          "junction", "an arm of three nodes from the middle of the slit",
          [](const FractureNetwork& network, double time) { return junction(network, 2, 3, spacing, time); }),
      conserving("several_at_once", "growth of both tips and an arm in one insertion",
                 [](const FractureNetwork& network, double time) {
                   return several_at_once(network, 6, spacing, time);
                 }),
      conserving("split_segment", "a segment replaced by two with a node between them",
                 [](const FractureNetwork& network, double time) { return split_segment(network, 5, time); }),
      {.name = "insertion.new_node_is_dry",
       .contract = contract,
       .expected = "a new node joins without content and without pressure",
       .physics = {claims::viscous_flow},
       .carry_out = new_node_is_dry},
      {.name = "insertion.new_node_fills_by_flow",
       .contract = contract,
       .expected = "a new node gets its fluid through its segments only",
       .physics = {claims::viscous_flow},
       .carry_out = new_node_fills_by_flow},
      {.name = "insertion.split_at_rest",
       .contract = contract,
       .expected = "a slit at rest is at rest after one of its segments was split",
       .carry_out = split_at_rest},
      {.name = "insertion.updated_lengths",
       .contract = contract,
       .expected = "a node whose length changes keeps its fluid, m l",
       .carry_out = updated_lengths},
      {.name = "insertion.natural_branch",
       .contract = "flow_solvers.md 3.7",
       .expected = "saturated nodes bring their pore fluid, l H aperture (1 + p_0 / K_f), once, as `found`",
       .physics = {claims::natural_fractures},
       .carry_out = finds_pore_fluid},
      {.name = "insertion.leaked_volume",
       .contract = contract,
       .expected = "the leaked volume l v is what it was, and the ledger closes with leak-off",
       .physics = {claims::leak_off},
       .carry_out = keeps_leaked_volume},
      {.name = "insertion.twenty_times",
       .contract = contract,
       .expected = "the ledger closes through twenty insertions",
       .carry_out = grows_many_times},
  };
}

}  // namespace fissura::coupler::conformance
