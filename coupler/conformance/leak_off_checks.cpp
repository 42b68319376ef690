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

// Leak-off after Carter, cumulative: exact at the end of an interval, whatever the steps (3e).
namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 3.4";
constexpr std::size_t nodes = 7;
constexpr double spacing = 0.5, rate = 2e-4;
constexpr StillRock soft{.aperture = 1e-4, .compliance = 1e-10};
/// Sums over steps and nodes.
constexpr double exact = 1e-9;

Case leaking(Case run_case, double coefficient, double spurt) {
  run_case.leak_off = {.coefficient = coefficient, .spurt_volume = spurt};
  return run_case;
}

/// V of (3e) of faces that were exposed `age` ago [m].
double carter(double coefficient, double spurt, double age) {
  return 2 * spurt + 4 * coefficient * std::sqrt(age);
}

StillScene scene_of(const Candidate& candidate, const Case& run_case) {
  return {candidate, run_case, straight_slit(nodes, spacing, nodes / 2), soft};
}

std::string takes(const Candidate& candidate, double coefficient, double spurt) {
  StillScene scene = scene_of(candidate, leaking(water_case(rate), coefficient, spurt));
  double expected = 0;
  for (const double duration : {0.1, 0.003, 0.25, 1e-4, 1.0, 0.1}) {
    scene.advance(duration);
    expected = water::thickness * scene.length() * carter(coefficient, spurt, scene.time);
    require_ratio(fmt::format("ledger.leaked at {:g} s [m3]", scene.time), scene.last.ledger.leaked, expected,
                  exact);
    require_injected(scene.last, rate * scene.time);
    require_balance(scene.driver, scene.last);
  }
  return fmt::format("{:.9g} m3 leaked, {:.9g} m3 by hand", scene.last.ledger.leaked, expected);
}

std::string root_of_time(const Candidate& candidate) {
  return takes(candidate, 1e-6, 0);
}

std::string spurt(const Candidate& candidate) {
  return takes(candidate, 0, 2e-6);
}

std::string both(const Candidate& candidate) {
  return takes(candidate, 5e-7, 1e-6);
}

/// Faces that are shut in lose fluid alike: the pressure is that of what is left.
std::string lowers_the_pressure(const Candidate& candidate) {
  constexpr double coefficient = 1e-8, pumping = 0.2, volume = rate * pumping;
  StillScene scene = scene_of(candidate, leaking(puff(rate, pumping), coefficient, 0));
  scene.advance(pumping);
  scene.come_to_rest(soft.aperture);
  const double content =
      soft.aperture + volume / (water::thickness * scene.length()) - carter(coefficient, 0, scene.time);
  const double expected = soft.pressure_of(content, water::bulk_modulus);
  const double tight = soft.pressure_of(content + carter(coefficient, 0, scene.time), water::bulk_modulus);
  for (const double pressure : scene.last.pressure)
    require_ratio("pressure of the leaking slit [Pa]", pressure, expected, solution_tolerance);
  require_balance(scene.driver, scene.last);
  return fmt::format("{:.7g} Pa, {:.7g} Pa by hand; {:.7g} Pa if it were tight", scene.last.pressure.front(),
                     expected, tight);
}

constexpr double thirsty = 1e-4;  // asks for the whole content of the slit within a second [m/s^0.5]

std::string dries_out(const Candidate& candidate) {
  StillScene scene = scene_of(candidate, leaking(water_case(0), thirsty, 0));
  for (int k = 0; k < 4; ++k) {
    scene.advance(2);
    require_ratio("ledger.leaked: all that was there [m3]", scene.last.ledger.leaked,
                  scene.last.ledger.in_place, exact);
    require_close("ledger.in_fractures [m3]", scene.last.ledger.in_fractures, 0,
                  exact * scene.last.ledger.in_place);
    require_closed(scene.last.ledger);
    for (std::size_t i = 0; i < nodes; ++i) {
      require_close(fmt::format("pressure of node {} [Pa]", i), scene.last.pressure[i], 0, 0);
      require_close(fmt::format("filled of node {}", i), scene.last.filled[i], 0, exact);
    }
  }
  return fmt::format("{:.6g} m3 leaked of {:.6g} m3, then nothing", scene.last.ledger.leaked,
                     scene.last.ledger.in_place);
}

/// The cell at the well has been asked for seven times what it held; what is pumped then goes that way.
std::string asks_again(const Candidate& candidate) {
  constexpr double dry_until = 4, heavy = 5e-4, duration = 0.1;
  Case run_case = water_case(0);
  add_stage(run_case, dry_until, heavy);
  StillScene scene = scene_of(candidate, leaking(run_case, thirsty, 0));
  scene.advance_many(2, dry_until / 2);
  scene.advance_many(10, duration);
  const double pumped = heavy * (scene.time - dry_until);
  require_injected(scene.last, pumped);
  require_closed(scene.last.ledger);
  // Whether a step takes before or after it has brought fluid, it leaves no more than what it brought.
  require_within("ledger.leaked [m3]", scene.last.ledger.leaked,
                 scene.last.ledger.in_place + pumped - heavy * duration,
                 (scene.last.ledger.in_place + pumped) * (1 + exact));
  return fmt::format("{:.6g} m3 leaked of {:.6g} m3 in place and pumped", scene.last.ledger.leaked,
                     scene.last.ledger.in_place + pumped);
}

/// The slit is old when it grows, so that the age of the new node is far from the time of the run.
constexpr double coefficient = 1e-6, grown_at = 40;

/// A slit of age `grown_at` that has just grown by a node.
class GrownSlit : public StillScene {
 public:
  explicit GrownSlit(const Candidate& candidate)
      : StillScene(candidate, leaking(water_case(rate), coefficient, 0),
                   straight_slit(nodes, spacing, nodes / 2), soft) {
    advance_many(4, grown_at / 4);
    insert(tip_growth(driver.network(), spacing, time));
  }
};

/// Volume per thickness that nodes of revision 0 have to give, their lengths being those of now [m2].
double of_old_nodes(const StillScene& scene) {
  double length = 0;
  for (std::size_t i = 0; i < nodes; ++i) length += scene.driver.network().nodes()[i].lumped_length;
  return length * carter(coefficient, 0, scene.time);
}

double of_new_node(const StillScene& scene) {
  return scene.driver.network().nodes()[nodes].lumped_length * carter(coefficient, 0, scene.time - grown_at);
}

/// l v stays: the lengthened node owes what its new length asks for, no more and no less.
std::string through_growth(const Candidate& candidate) {
  GrownSlit scene(candidate);
  const double before = scene.last.ledger.leaked;
  scene.advance(1e-3);
  const double least = water::thickness * of_old_nodes(scene),
               most = least + water::thickness * of_new_node(scene);
  require_within("ledger.leaked right after the growth [m3]", scene.last.ledger.leaked, least * (1 - exact),
                 most * (1 + exact));
  require_balance(scene.driver, scene.last);
  return fmt::format("from {:.6g} m3 to {:.6g} m3, {:.6g} m3 by hand", before, scene.last.ledger.leaked,
                     least);
}

/// A new node is exposed from when it joined; a cell that is swept little by little asks for 2/3 at least.
std::string since_exposure(const Candidate& candidate) {
  GrownSlit scene(candidate);
  scene.advance_many(8, grown_at / 80);
  const double old_nodes = of_old_nodes(scene), new_node = of_new_node(scene);
  const double share = (scene.last.ledger.leaked / water::thickness - old_nodes) / new_node;
  const double slack = exact * old_nodes / new_node;
  require_within("what the new node has lost, by (3e) of its own exposure_time", share, 2.0 / 3 - slack,
                 1 + slack);
  require_balance(scene.driver, scene.last);
  return fmt::format("{:.4f} of (3e) for faces {:g} s old", share, scene.time - grown_at);
}

/// Nothing that the case does not ask for.
std::string tight(const Candidate& candidate) {
  StillScene scene = scene_of(candidate, water_case(rate));
  scene.advance_many(5, 1);
  require_close("ledger.leaked without leak-off [m3]", scene.last.ledger.leaked, 0, 0);
  return "0 m3 leaked";
}

}  // namespace

std::vector<Check> leak_off_checks() {
  const std::set<std::string> carter_law{claims::leak_off};
  return {
      {.name = "leak_off.none",
       .contract = contract,
       .expected = "nothing leaks where the case has no leak-off",
       .carry_out = tight},
      {.name = "leak_off.root_of_time",
       .contract = contract,
       .expected = "4 C_l sqrt(t) per trace length, whatever the intervals",
       .physics = carter_law,
       .carry_out = root_of_time},
      {.name = "leak_off.spurt",
       .contract = contract,
       .expected = "2 S_p at once, and no more",
       .physics = carter_law,
       .carry_out = spurt},
      {.name = "leak_off.both",
       .contract = contract,
       .expected = "2 S_p + 4 C_l sqrt(t) per trace length",
       .physics = carter_law,
       .carry_out = both},
      {.name = "leak_off.lowers_the_pressure",
       .contract = contract,
       .expected = "the pressure of a slit that is shut in is that of the content that has not leaked",
       .physics = carter_law,
       .carry_out = lowers_the_pressure},
      {.name = "leak_off.dries_out",
       .contract = contract,
       .expected = "no more is taken than is there",
       .physics = carter_law,
       .carry_out = dries_out},
      {.name = "leak_off.asks_again",
       .contract = contract,
       .expected = "what a dry node could not give is taken when fluid comes",
       .physics = carter_law,
       .carry_out = asks_again},
      {.name = "leak_off.through_growth",
       .contract = "flow_solvers.md 5",
       .expected = "a tip that has grown owes (3e) of its new length, less what it has lost",
       .physics = carter_law,
       .capabilities = {"insert"},
       .carry_out = through_growth},
      {.name = "leak_off.since_exposure",
       .contract = contract,
       .expected = "a new node loses what (3e) says of its own exposure_time, or two thirds of it at least",
       .physics = carter_law,
       .capabilities = {"insert"},
       .carry_out = since_exposure},
  };
}

}  // namespace fissura::coupler::conformance
