// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "coupler/conformance/balance.hpp"
#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/physics_checks.hpp"
#include "coupler/conformance/still_rock.hpp"
#include "coupler/conformance/topologies.hpp"

// Nodes that are empty or half full: p = 0 there, and no fluid passes before they are full.
namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 3.1";
constexpr std::size_t full = 3, empty = 4;
constexpr double spacing = 0.5, rate = 1e-4;
constexpr StillRock rigid{.aperture = 1e-4};

/// A slit of `full` nodes, pumped in the west, to whose east end `empty` nodes join.
class DrySlit : public StillScene {
 public:
  DrySlit(const Candidate& candidate, const Case& run_case)
      : StillScene(candidate, run_case, straight_slit(full, spacing, 0), rigid) {
    advance(1e-6);
    for (std::size_t k = 0; k < empty; ++k) insert(tip_growth(driver.network(), spacing, time));
  }
};

std::string front(const Candidate& candidate) {
  DrySlit slit(candidate, water_case(rate));
  // Long enough that water in a rigid slit has no memory of it, short enough to see every node fill.
  constexpr double duration = 0.05;
  int intervals = 0;
  std::vector<double> before(full + empty, 0.0);
  do {
    require(++intervals <= 200, "the last node full after what fills all nodes twice", "it is not");
    slit.advance(duration);
    require_injected(slit.last, rate * slit.time);
    require_balance(slit.driver, slit.last);
    const std::vector<double>& filled = slit.last.filled;
    for (std::size_t i = full; i < full + empty; ++i) {
      if (filled[i] < 1)
        require_close(fmt::format("pressure of node {}, filled {:.3g} [Pa]", i, filled[i]),
                      slit.last.pressure[i], 0, 0);
      require_within(fmt::format("filled of node {} in interval {}", i, intervals), filled[i],
                     before[i] - 1e-9, 1);
      if (i + 1 < full + empty && filled[i] < 1)
        require_close(
            fmt::format("filled of node {}, whose only neighbour towards the well is not full", i + 1),
            filled[i + 1], before[i + 1], 1e-9);
    }
    before = filled;
  } while (slit.last.pressure.back() <= 0);
  const double room = rigid.aperture * slit.length() * water::thickness;
  require_within("volume in the fractures when the last node has filled, by what fills them",
                 slit.last.ledger.in_fractures / room, 1, 1.02);
  return fmt::format("{} nodes one after the other, {:.4g} m3 in {:.4g} m3", empty,
                     slit.last.ledger.in_fractures, room);
}

/// While one node fills, nothing else changes: all that is pumped goes there.
std::string right_volume(const Candidate& candidate) {
  DrySlit slit(candidate, water_case(rate));
  constexpr double duration = 0.05;
  slit.advance_many(12, duration);  // the old tip stands for twice its length now, and fills first
  const std::size_t node = full;  // the first of the empty ones
  const double room = rigid.aperture * slit.driver.network().nodes()[node].lumped_length * water::thickness;
  for (int k = 0; k < 4; ++k) {
    const double before = slit.last.filled[node];
    slit.advance(duration);
    require_within("filled of the first empty node", slit.last.filled[node], 0, 0.999);
    // The full nodes upstream stand under a steady pressure by now.
    require_close("growth of filled in an interval", slit.last.filled[node] - before, rate * duration / room,
                  1e-4 * rate * duration / room);
  }
  return fmt::format("filled {:.6g} after {:g} s", slit.last.filled[node], slit.time);
}

/// Nodes without fluid that nothing reaches.
std::string stays_dry(const Candidate& candidate) {
  StillScene scene(candidate, water_case(0), straight_slit(full, spacing, 1),
                   {.aperture = 0, .compliance = 1e-10});
  const double room = 1e-4 * scene.length() * water::thickness;
  scene.advance(0.01);
  std::fill(scene.asked.aperture.begin(), scene.asked.aperture.end(), 1e-4);
  for (int k = 0; k < 4; ++k) {
    scene.advance(0.1);
    for (std::size_t i = 0; i < full; ++i) {
      require_close(fmt::format("pressure of node {} [Pa]", i), scene.last.pressure[i], 0, 0);
      require_close(fmt::format("filled of node {}", i), scene.last.filled[i], 0, rounding);
      require_ratio(fmt::format("aperture_predicted of node {} [m]", i), scene.last.aperture_predicted[i],
                    1e-4, rounding);
    }
  }
  for (const double entry : {scene.last.ledger.injected, scene.last.ledger.in_place,
                             scene.last.ledger.in_fractures, scene.last.ledger.leaked})
    require_close("every entry of the ledger [m3]", entry, 0, rounding * room);
  return "pressure, filled and ledger are 0";
}

/// An empty slit takes exactly what is pumped, and gets a pressure when it is full.
std::string from_empty(const Candidate& candidate) {
  const StillRock soft{.aperture = 1e-4, .compliance = 1e-10};
  constexpr std::size_t nodes = 5;
  StillScene scene(candidate, water_case(rate), straight_slit(nodes, spacing, nodes / 2),
                   {.aperture = 0, .compliance = 1e-10});
  // The stage begins at 0: what is pumped in the first interval opens the slit.
  scene.advance(1e-3);
  require_close("ledger.in_place [m3]", scene.last.ledger.in_place, 0, 0);
  std::fill(scene.asked.aperture.begin(), scene.asked.aperture.end(), soft.aperture);
  const double room = soft.aperture * scene.length() * water::thickness;
  while (rate * scene.time < 1.5 * room) {
    scene.advance(room / rate / 10);
    require_injected(scene.last, rate * scene.time);
    require_balance(scene.driver, scene.last);
  }
  for (std::size_t i = 0; i < nodes; ++i)
    require_within(fmt::format("pressure of node {} of the filled slit [Pa]", i), scene.last.pressure[i], 1,
                   1e9);
  return fmt::format("{:.4g} m3 in a room of {:.4g} m3", scene.last.ledger.in_fractures, room);
}

/// A node whose faces part faster than fluid comes loses its pressure, and gets it back.
std::string empties_and_fills(const Candidate& candidate) {
  constexpr std::size_t nodes = 5;
  StillScene scene(candidate, water_case(rate), straight_slit(nodes, spacing, nodes / 2), rigid);
  scene.advance_many(2, 1e-3);
  scene.asked.aperture.back() *= 2;
  scene.advance(1e-3);
  require_close("pressure of the node that parts [Pa]", scene.last.pressure.back(), 0, 0);
  require_within("its filled", scene.last.filled.back(), 0.4, 0.999);
  require_balance(scene.driver, scene.last);
  scene.advance_many(40, 0.02);
  require_close("filled of the node that parted, later", scene.last.filled.back(), 1, 0);
  require_within("its pressure [Pa]", scene.last.pressure.back(), 1, 1e10);
  require_balance(scene.driver, scene.last);
  require_injected(scene.last, rate * scene.time);
  return fmt::format("no pressure at once, {:.4g} Pa later", scene.last.pressure.back());
}

/// No room and no yield: fluid passes by, over the floor of the conductance, and none stays.
std::string without_aperture(const Candidate& candidate) {
  constexpr std::size_t middle = 2;
  StillScene scene(candidate, water_case(rate / 100), straight_slit(5, spacing, 0), rigid);
  scene.asked.aperture[middle] = 0;
  scene.advance_many(3, 0.02);
  require_close("aperture_predicted of the node without aperture [m]", scene.last.aperture_predicted[middle],
                0, 0);
  require_balance(scene.driver, scene.last);
  require_injected(scene.last, rate / 100 * scene.time);
  require_within("its pressure [Pa], between those of its neighbours", scene.last.pressure[middle],
                 scene.last.pressure[middle + 1], scene.last.pressure[middle - 1]);
  require_within("pressure beyond it [Pa]", scene.last.pressure.back(), 1, scene.last.pressure.front());
  return fmt::format("{:.6g} Pa, {:.6g} Pa, {:.6g} Pa", scene.last.pressure[middle - 1],
                     scene.last.pressure[middle], scene.last.pressure[middle + 1]);
}

}  // namespace

std::vector<Check> filling_checks() {
  const std::set<std::string> flow{claims::viscous_flow}, growth{"insert"};
  return {
      {.name = "filling.stays_dry",
       .contract = contract,
       .expected = "a network that has no fluid and gets none has no pressure",
       .carry_out = stays_dry},
      {.name = "filling.from_empty",
       .contract = contract,
       .expected = "a slit that begins empty holds what is pumped, and has a pressure when it is full",
       .carry_out = from_empty},
      {.name = "filling.front",
       .contract = contract,
       .expected = "empty nodes fill one after the other, p = 0 until full, none passes fluid before that",
       .physics = flow,
       .capabilities = growth,
       .carry_out = front},
      {.name = "filling.right_volume",
       .contract = contract,
       .expected = "filled grows by what is pumped, per room of the node",
       .physics = flow,
       .capabilities = growth,
       .carry_out = right_volume},
      {.name = "filling.empties_and_fills",
       .contract = contract,
       .expected = "a node that parts faster than it fills has p = 0 at once, and a pressure when full again",
       .physics = flow,
       .carry_out = empties_and_fills},
      {.name = "filling.without_aperture",
       .contract = "flow_solvers.md 3.6",
       .expected =
           "a node without aperture stores nothing, takes a pressure between its neighbours', lets pass",
       .physics = flow,
       .carry_out = without_aperture},
  };
}

}  // namespace fissura::coupler::conformance
