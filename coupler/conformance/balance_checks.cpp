// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coupler/conformance/balance.hpp"
#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/physics_checks.hpp"
#include "coupler/conformance/pumped_slit.hpp"
#include "coupler/conformance/still_rock.hpp"
#include "coupler/conformance/topologies.hpp"

// The ledger, and what is made anew under carry = "pressure".
namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 4";
constexpr std::size_t nodes = 7;
constexpr double spacing = 0.5, rate = 2e-4;
constexpr StillRock soft{.aperture = 1e-4, .compliance = 1e-10};

/// Nothing leaks, nothing is found, nothing is reset: what is pumped is in the fractures, to rounding.
std::string plain(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  double in_place = 0;
  for (int k = 0; k < 20; ++k) {
    scene.advance();
    const FluidLedger& ledger = scene.last.ledger;
    if (k == 0) in_place = ledger.in_place;
    require_close("ledger.in_place [m3], as after the first interval", ledger.in_place, in_place, 0);
    for (const auto& [entry, value] :
         {std::pair{"leaked", ledger.leaked}, {"found", ledger.found}, {"reset", ledger.reset}})
      require_close(fmt::format("ledger.{} [m3]", entry), value, 0, 0);
    require_injected(scene.last, PumpedSlit::rate * scene.time);
    require_ratio("ledger.in_fractures [m3]", ledger.in_fractures, in_place + ledger.injected,
                  ledger_tolerance);
    require_balance(scene.driver, scene.last);
  }
  return fmt::format("residual {:.1e} m3 of {:.3g} m3", scene.last.ledger.residual(),
                     scene.last.ledger.in_fractures);
}

/// What is pumped in a long run of short intervals adds up, beside a thousand times as much in place.
std::string many_intervals(const Candidate& candidate) {
  constexpr int intervals = 600;
  constexpr double small = rate / 100;
  StillScene scene(candidate, water_case(small), straight_slit(nodes, spacing, nodes / 2), soft);
  scene.advance_many(intervals, 1e-3);
  require_injected(scene.last, small * scene.time);
  require_balance(scene.driver, scene.last);
  return fmt::format("residual {:.1e} m3 of {:.3g} m3 after {} intervals", scene.last.ledger.residual(),
                     scene.last.ledger.in_fractures, intervals);
}

/// The stretch from 0 to 2 s in more and more intervals: answers come closer to each other.
std::string divided(const Candidate& candidate) {
  constexpr double end = 2;
  std::vector<std::vector<double>> pressures;
  for (const int intervals : {20, 40, 80}) {
    StillScene scene(candidate, water_case(rate), straight_slit(nodes, spacing, nodes / 2),
                     {.aperture = 1e-4, .compliance = 1e-9});
    scene.advance_many(intervals, end / intervals);
    pressures.push_back(scene.last.pressure);
  }
  const double scale = *std::max_element(pressures[2].begin(), pressures[2].end());
  const auto difference = [&](std::size_t a, std::size_t b) {
    double greatest = 0;
    for (std::size_t i = 0; i < nodes; ++i)
      greatest = std::max(greatest, std::abs(pressures[a][i] - pressures[b][i]) / scale);
    return greatest;
  };
  // The time constants of the slit are a second and more; a first-order scheme with one step in each interval
  // is off by about the share of the interval in it, and halves that with the interval.
  const double coarse = difference(0, 1), fine = difference(1, 2);
  require_within("change of the pressures from 20 to 40 intervals, of the greatest", coarse, 0, 0.05);
  require_within("change from 40 to 80 intervals, of the greatest", fine, 0, 0.75 * coarse + 1e-6);
  return fmt::format("{:.1e} of the greatest pressure from 20 to 40 intervals, {:.1e} from 40 to 80", coarse,
                     fine);
}

/// Flux of FIELDS from node_a to node_b, where a solver tells it.
std::string flux(const Candidate& candidate) {
  constexpr double through = rate / water::thickness;
  OpenSlit slit(candidate, water_case(rate), {.aperture = 1e-4});
  slit.settle();
  const std::optional<std::vector<double>> told = slit.driver.report().find("flux");
  if (!told) return "it does not tell the flux";
  const FractureNetwork& network = slit.driver.network();
  for (std::size_t s = 0; s < told->size(); ++s) {
    const NetworkSegment& segment = network.segments()[s];
    const bool eastward = network.index_of(segment.node_a) < network.index_of(segment.node_b);
    require_ratio(fmt::format("flux of segment {} from node_a to node_b [m2/s]", s), told->at(s),
                  eastward ? through : -through, solution_tolerance);
  }
  return fmt::format("{:.6g} m2/s along each segment", through);
}

/// Content is made anew of the aperture and the last pressure, and booked.
std::string reset(const Candidate& candidate) {
  constexpr double pumping = 0.02, puff_rate = 4e-5, wider = 1e-6;
  StillScene scene(candidate, puff(puff_rate, pumping), straight_slit(nodes, spacing, nodes / 2),
                   {.aperture = 1e-4});
  scene.advance(pumping);
  scene.come_to_rest(1e-4);
  const double pressure = scene.last.pressure.front();
  scene.asked.carry = Carry::pressure;
  for (double& aperture : scene.asked.aperture) aperture += wider;
  scene.advance(pumping);
  const double expected = water::thickness * scene.length() * wider * (1 + pressure / water::bulk_modulus);
  require_ratio("ledger.reset [m3]", scene.last.ledger.reset, expected, solution_tolerance);
  require_balance(scene.driver, scene.last);
  for (std::size_t i = 0; i < nodes; ++i)
    require_ratio(fmt::format("pressure of node {}, which is kept [Pa]", i), scene.last.pressure[i], pressure,
                  solution_tolerance);
  return fmt::format("{:.6g} m3 reset, {:.6g} m3 by hand", scene.last.ledger.reset, expected);
}

}  // namespace

std::vector<Check> balance_checks() {
  const std::set<std::string> flow{claims::viscous_flow}, carry{claims::carry_pressure};
  return {
      {.name = "ledger.plain",
       .contract = contract,
       .expected = "in_place stays, leaked, found and reset are 0, all that is pumped is in the fractures",
       .carry_out = plain},
      {.name = "ledger.many_intervals",
       .contract = contract,
       .expected = "sums over many intervals keep what rounding takes away",
       .carry_out = many_intervals},
      {.name = "ledger.flux",
       .contract = "flow_solvers.md 2.2",
       .expected = "flux in FIELDS is that from node_a to node_b",
       .physics = flow,
       .capabilities = {"insert", "report"},
       .carry_out = flux},
      {.name = "diffusion.divided",
       .contract = "flow_solvers.md 3",
       .expected = "more intervals for the same time: answers that converge",
       .physics = flow,
       .carry_out = divided},
      {.name = "carry.reset",
       .contract = "flow_solvers.md 3.1",
       .expected = "under carry = pressure the content is made anew, and the difference is booked as reset",
       .physics = carry,
       .carry_out = reset},
  };
}

}  // namespace fissura::coupler::conformance
