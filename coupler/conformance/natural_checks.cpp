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

// Natural fractures: full of pore fluid, open under it by their joints.
namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 3.7";
constexpr std::size_t nodes = 5;
constexpr double spacing = 0.5, pumping = 0.02;
constexpr double slit_length = spacing * (nodes - 1);
constexpr double aperture = 1e-4, formation_pressure = 2e5, joint_compliance = 1e-10;

/// Of a node that was found full, per area of face, and of what was pumped since [m].
double content_after(double rate) {
  return aperture * (1 + formation_pressure / water::bulk_modulus) +
         rate * pumping / (water::thickness * slit_length);
}

/// A natural slit that was pumped and has come to rest between faces of `rock`.
class RestedJoint : public StillScene {
 public:
  RestedJoint(const Candidate& candidate, double rate, const StillRock& rock_)
      : StillScene(candidate, puff(rate, pumping),
                   natural_slit(nodes, spacing, nodes / 2, formation_pressure, joint_compliance), rock_) {
    advance(pumping);
    advance_many(6, 20);  // a hundred times the slowest time constant of joints of this compliance
    require_injected(last, rate * pumping);
    require_closed(last.ledger);
    require_ratio("ledger.in_place [m3]", last.ledger.in_place,
                  water::thickness * slit_length * content_after(0), rounding);
  }
};

std::string require_pressure(const StillScene& scene, const StillRock& as_one, double content) {
  const double expected = as_one.pressure_of(content, water::bulk_modulus);
  for (std::size_t i = 0; i < nodes; ++i) {
    require_ratio(fmt::format("pressure of node {} [Pa]", i), scene.last.pressure[i], expected,
                  solution_tolerance);
    require_ratio(fmt::format("aperture_predicted of node {}, without its joint [m]", i),
                  scene.last.aperture_predicted[i], scene.rock.aperture_at(scene.last.pressure[i]), rounding);
  }
  return fmt::format("{:.7g} Pa, {:.7g} Pa by hand", scene.last.pressure.front(), expected);
}

std::string found_at_rest(const Candidate& candidate) {
  const StillRock closed{.aperture = aperture, .compliance = 0, .reference_pressure = 1e7, .closed = 1};
  const RestedJoint scene(candidate, 0, closed);
  for (std::size_t i = 0; i < nodes; ++i)
    require_ratio(fmt::format("pressure of node {} [Pa]", i), scene.last.pressure[i], formation_pressure,
                  solution_tolerance);
  return fmt::format("{:.7g} Pa, in place {:.7g} m3", scene.last.pressure.front(),
                     scene.last.ledger.in_place);
}

/// e = a + c_s (p - p_0): as a rock of the joint's compliance that was measured under the pore pressure.
std::string joint_opens(const Candidate& candidate) {
  constexpr double rate = 2e-3;
  const StillRock closed{.aperture = aperture, .compliance = 5e-11, .reference_pressure = 1e7, .closed = 1};
  const RestedJoint scene(candidate, rate, closed);
  return require_pressure(
      scene, {.aperture = aperture, .compliance = joint_compliance, .reference_pressure = formation_pressure},
      content_after(rate));
}

/// Beyond p_c the faces are apart: the joint stays as far open as it was there, the rock yields.
std::string faces_part(const Candidate& candidate) {
  constexpr double rate = 8e-3, contact_pressure = 4e5;
  const StillRock closed{
      .aperture = aperture, .compliance = 5e-11, .reference_pressure = contact_pressure, .closed = 1};
  const RestedJoint scene(candidate, rate, closed);
  return require_pressure(scene,
                          {.aperture = aperture + joint_compliance * (contact_pressure - formation_pressure),
                           .compliance = closed.compliance,
                           .reference_pressure = contact_pressure},
                          content_after(rate));
}

/// Steady flow to a basin: joints that fluid opens conduct as wide as they are then.
std::string conducts(const Candidate& candidate) {
  constexpr double rate = 2e-5, flux = rate / water::thickness, compliance = 1e-10;
  StillScene scene(candidate, water_case(rate),
                   natural_slit(nodes, spacing, 0, formation_pressure, compliance),
                   {.aperture = aperture, .reference_pressure = 1e8, .closed = 1});
  scene.advance(1e-6);
  scene.insert(basin(scene.driver.network(), nodes - 1, spacing, scene.time));
  scene.asked.aperture.back() = 1e-2;  // room for all that is pumped; the arm to it is not wider
  scene.asked.arm_aperture_a.assign(nodes, aperture);
  scene.asked.arm_aperture_b.assign(nodes, aperture);
  // The joint takes in, until flow is steady; the last conductance lags behind.
  scene.advance_many(60, 2);
  const auto open = [&](double pressure) { return aperture + compliance * (pressure - formation_pressure); };
  const auto through = [&](double from, double to) {
    return std::pow((open(from) + open(to)) / 2, 3) / (12 * water::viscosity * spacing) * (from - to);
  };
  // The segment to the basin is no natural one.
  double downstream = 12 * water::viscosity * flux * spacing / std::pow(aperture, 3);
  require_ratio("pressure of the last natural node [Pa]", scene.last.pressure[nodes - 1], downstream, 1e-5);
  for (std::size_t i = nodes - 1; i-- > 0;) {
    double low = downstream, high = downstream + 1e6;
    for (int k = 0; k < 200; ++k)
      (through((low + high) / 2, downstream) < flux ? low : high) = (low + high) / 2;
    require_ratio(fmt::format("pressure of node {} [Pa]", i), scene.last.pressure[i], low, 1e-5);
    downstream = low;
  }
  require_closed(scene.last.ledger);
  return fmt::format("{:.6g} Pa at the well, {:.6g} Pa by hand", scene.last.pressure.front(), downstream);
}

/// Pore fluid does not leak; injected fluid does, once it has replaced it.
std::string leaks_behind_the_front(const Candidate& candidate) {
  constexpr double coefficient = 1e-7, rate = 1e-4;
  Case run_case = water_case(rate);
  run_case.leak_off.coefficient = coefficient;
  StillScene scene(candidate, run_case, natural_slit(nodes, spacing, 0, formation_pressure, joint_compliance),
                   {.aperture = aperture, .reference_pressure = 1e8, .closed = 1});
  // The cell at the well holds 0.25 m x 0.1 mm.
  const double replaced =
      water::thickness * spacing / 2 * aperture * (1 + formation_pressure / water::bulk_modulus) / rate;
  scene.advance_many(4, replaced / 5);
  require_close("ledger.leaked before the pore fluid of the first cell is replaced [m3]",
                scene.last.ledger.leaked, 0, 0);
  scene.advance_many(20, replaced);
  require_within("ledger.leaked when some of it is [m3]", scene.last.ledger.leaked,
                 water::thickness * spacing / 2 * 2 * coefficient * std::sqrt(scene.time / 2),
                 water::thickness * slit_length * 4 * coefficient * std::sqrt(scene.time));
  require_closed(scene.last.ledger);
  return fmt::format("nothing until {:.3g} s, {:.4g} m3 until {:.3g} s", 0.8 * replaced,
                     scene.last.ledger.leaked, scene.time);
}

}  // namespace

std::vector<Check> natural_checks() {
  const std::set<std::string> joints{claims::natural_fractures};
  return {
      {.name = "natural.found",
       .contract = contract,
       .expected = "saturated nodes begin with their pore fluid under p_0, which is in place, and stay so",
       .physics = joints,
       .carry_out = found_at_rest},
      {.name = "natural.joint_opens",
       .contract = contract,
       .expected = "content uses e(p) + c_s (p - p_0) while the faces touch, aperture_predicted does not",
       .physics = joints,
       .carry_out = joint_opens},
      {.name = "natural.faces_part",
       .contract = contract,
       .expected = "the joint opens up to p_c and no further",
       .physics = joints,
       .carry_out = faces_part},
      {.name = "natural.conducts",
       .contract = contract,
       .expected = "steady flow falls as conductances of joints demand that the fluid has opened",
       .physics = {claims::natural_fractures, claims::viscous_flow},
       .capabilities = {"insert"},
       .carry_out = conducts},
      {.name = "natural.leaks_behind_the_front",
       .contract = contract,
       .expected = "leak-off begins where injected fluid has replaced the pore fluid",
       .physics = {claims::natural_fractures, claims::leak_off},
       .carry_out = leaks_behind_the_front},
  };
}

}  // namespace fissura::coupler::conformance
