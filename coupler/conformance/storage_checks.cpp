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

// Pressure from content, in slits that have come to rest: one pressure, one content, no conductance in it.
namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 3.1";
constexpr std::size_t nodes = 5;
constexpr double spacing = 0.5, pumping_time = 0.02;
constexpr StillRock rigid{.aperture = 1e-4};
constexpr StillRock soft{.aperture = 1e-4, .compliance = 1e-10};

/// A slit that was pumped at `rate` for `pumping_time` and has come to rest.
class RestedSlit : public StillScene {
 public:
  RestedSlit(const Candidate& candidate, double rate, const StillRock& rock_)
      : StillScene(candidate, puff(rate, pumping_time), straight_slit(nodes, spacing, nodes / 2), rock_) {
    advance(pumping_time);
    come_to_rest();
  }
  void come_to_rest() { StillScene::come_to_rest(rock.aperture); }
};

/// m of each node of a slit at rest, from the volumes of the check alone [m].
double content_at_rest(const StillScene& scene, double rate) {
  return scene.rock.aperture + rate * pumping_time / (water::thickness * scene.length());
}

std::string require_pressure(const StillScene& scene, double content) {
  const double expected = scene.rock.pressure_of(content, water::bulk_modulus);
  require(expected > 0, "a positive pressure by (3c)", fmt::format("{:g} Pa", expected));
  for (std::size_t i = 0; i < scene.last.pressure.size(); ++i)
    require_ratio(fmt::format("pressure of node {} [Pa]", i), scene.last.pressure[i], expected,
                  solution_tolerance);
  return fmt::format("{:.7g} Pa, {:.7g} Pa by hand", scene.last.pressure.front(), expected);
}

std::string rest_pressure(const Candidate& candidate, double rate, const StillRock& rock) {
  const RestedSlit scene(candidate, rate, rock);
  require_balance(scene.driver, scene.last);
  return require_pressure(scene, content_at_rest(scene, rate));
}

std::string compressibility(const Candidate& candidate) {
  return rest_pressure(candidate, 4e-5, rigid);
}

std::string compliance(const Candidate& candidate) {
  return rest_pressure(candidate, 2e-2, soft);
}

/// Nothing is pumped: the content is the measured aperture, which fits a pressure just below the reference.
std::string reference_pressure(const Candidate& candidate) {
  constexpr double shift = 4e5;
  StillRock rock = soft;
  rock.reference_pressure = 5e5;
  RestedSlit scene(candidate, 0, rock);
  (void)require_pressure(scene, rock.aperture);
  const double before = scene.last.pressure.front();
  scene.rock.reference_pressure += shift;
  std::fill(scene.asked.reference_pressure.begin(), scene.asked.reference_pressure.end(),
            scene.rock.reference_pressure);
  scene.come_to_rest();
  (void)require_pressure(scene, rock.aperture);
  require_balance(scene.driver, scene.last);
  return fmt::format("{:.6g} Pa; {:.6g} Pa with a reference of {:g} Pa more", before,
                     scene.last.pressure.front(), shift);
}

/// Below the reference the fluid alone yields, above it the rock does.
std::string closed(const Candidate& candidate) {
  StillRock touching = soft;
  touching.closed = 1;
  touching.reference_pressure = 1e6;
  constexpr double little = 4e-6, much = 2e-2;
  const std::string below = rest_pressure(candidate, little, touching);
  const std::string above = rest_pressure(candidate, much, touching);
  return fmt::format("below the reference of 1e6 Pa {}; above {}", below, above);
}

/// Nodes that differ in everything, and from interval to interval: e of (3b) at the pressure that is
/// answered, each for itself.
std::string aperture_predicted(const Candidate& candidate) {
  StillScene scene(candidate, puff(2e-3, pumping_time), straight_slit(nodes, spacing, nodes / 2), soft);
  for (std::size_t k = 0; k < 5; ++k) {
    std::vector<StillRock> rocks;
    for (std::size_t i = 0; i < nodes; ++i) {
      const auto place = static_cast<double>(i), time = static_cast<double>(k);
      rocks.push_back({.aperture = (1 + 0.1 * place + 0.02 * time) * 1e-4,
                       .compliance = (3 + place + time) * 1e-11,
                       .reference_pressure = 2e4 * place * (1 + time),
                       .closed = static_cast<unsigned char>((i + k) % 2)});
      scene.asked.aperture[i] = rocks[i].aperture;
      scene.asked.compliance[i] = rocks[i].compliance;
      scene.asked.reference_pressure[i] = rocks[i].reference_pressure;
      scene.asked.closed[i] = rocks[i].closed;
    }
    scene.advance(pumping_time);
    for (std::size_t i = 0; i < nodes; ++i)
      require_ratio(fmt::format("aperture_predicted of node {} in interval {} [m]", i, k + 1),
                    scene.last.aperture_predicted[i], rocks[i].aperture_at(scene.last.pressure[i]), rounding);
    require_balance(scene.driver, scene.last);
  }
  return fmt::format("{:.6g} m to {:.6g} m, each e(p) of its node", scene.last.aperture_predicted.front(),
                     scene.last.aperture_predicted.back());
}

/// The rock did what was not predicted: the content is kept, the pressure is found anew.
std::string squeezed(const Candidate& candidate) {
  constexpr double rate = 4e-5, squeeze = 5e-8;
  RestedSlit scene(candidate, rate, rigid);
  const FluidLedger before = scene.last.ledger;
  const double content = content_at_rest(scene, rate), pressure = scene.last.pressure.front();
  scene.rock.aperture -= squeeze;
  std::fill(scene.asked.aperture.begin(), scene.asked.aperture.end(), scene.rock.aperture);
  scene.come_to_rest();
  require_ratio("ledger.in_fractures [m3]", scene.last.ledger.in_fractures, before.in_fractures, rounding);
  require_closed(scene.last.ledger);
  (void)require_pressure(scene, content);
  return fmt::format("from {:.6g} Pa to {:.6g} Pa, the volume is kept", pressure,
                     scene.last.pressure.front());
}

/// Wider than the fluid fills: no pressure, and the share that it fills.
std::string opened(const Candidate& candidate) {
  constexpr double rate = 4e-5, wider = 1.25;
  RestedSlit scene(candidate, rate, rigid);
  const double content = content_at_rest(scene, rate), volume = scene.last.ledger.in_fractures;
  scene.rock.aperture *= wider;
  std::fill(scene.asked.aperture.begin(), scene.asked.aperture.end(), scene.rock.aperture);
  // Rigid faces open no further, whatever pressure they were measured under.
  std::fill(scene.asked.reference_pressure.begin(), scene.asked.reference_pressure.end(), 5e5);
  scene.advance(pumping_time);
  const double expected = content / scene.rock.aperture;
  for (std::size_t i = 0; i < nodes; ++i) {
    require_close(fmt::format("pressure of node {} [Pa]", i), scene.last.pressure[i], 0, 0);
    require_ratio(fmt::format("filled of node {}", i), scene.last.filled[i], expected, solution_tolerance);
    require_ratio(fmt::format("aperture_predicted of node {} [m]", i), scene.last.aperture_predicted[i],
                  scene.rock.aperture, rounding);
  }
  require_ratio("ledger.in_fractures [m3]", scene.last.ledger.in_fractures, volume, rounding);
  return fmt::format("filled {:.6g}, {:.6g} by hand, no pressure", scene.last.filled.front(), expected);
}

/// What is sent as aperture need not fit e(0): a reference above what the aperture allows closes the node.
std::string never_negative(const Candidate& candidate) {
  StillRock rock = soft;
  rock.reference_pressure = 3e6;  // e(0) would be -2e-4 m
  const RestedSlit scene(candidate, 0, rock);
  (void)require_pressure(scene, rock.aperture);
  return fmt::format("{:.6g} Pa: e(0) is 0, not less", scene.last.pressure.front());
}

/// A node without content whose faces pressure would first have to lift: its aperture is 0, not less, under
/// the pressure of its neighbour.
std::string pressed_shut(const Candidate& candidate) {
  constexpr double rate = 1e-5;
  StillScene scene(candidate, puff(rate, pumping_time), straight_slit(nodes, spacing, nodes / 2), rigid);
  scene.asked.aperture.back() = 0;
  scene.asked.reference_pressure.back() = 3e6;
  scene.asked.compliance.back() = 1e-10;
  scene.advance(pumping_time);
  scene.come_to_rest(rigid.aperture);
  const double share = rate * pumping_time / (scene.last.ledger.in_place);
  const double expected = water::bulk_modulus * share;
  for (std::size_t i = 0; i < nodes; ++i)
    require_ratio(fmt::format("pressure of node {} [Pa]", i), scene.last.pressure[i], expected,
                  solution_tolerance);
  require_close("aperture_predicted of the node that is pressed shut [m]",
                scene.last.aperture_predicted.back(), 0, 0);
  require_balance(scene.driver, scene.last);
  return fmt::format("{:.7g} Pa, {:.7g} Pa by hand, no aperture", scene.last.pressure.back(), expected);
}

/// The aperture closes while nothing is pumped: the pressure is that of the same content.
std::string aperture_rate(const Candidate& candidate) {
  constexpr double rate = 4e-5, duration = 0.05, closing = -2e-6;
  RestedSlit scene(candidate, rate, rigid);
  const double narrowed = rigid.aperture + closing * duration;
  std::fill(scene.asked.aperture_rate.begin(), scene.asked.aperture_rate.end(), closing);
  scene.advance(duration);
  const double expected =
      StillRock{.aperture = narrowed}.pressure_of(content_at_rest(scene, rate), water::bulk_modulus);
  for (std::size_t i = 0; i < nodes; ++i) {
    require_ratio(fmt::format("aperture_predicted of node {} [m]", i), scene.last.aperture_predicted[i],
                  narrowed, rounding);
    require_ratio(fmt::format("pressure of node {} [Pa]", i), scene.last.pressure[i], expected,
                  solution_tolerance);
  }
  require_balance(scene.driver, scene.last);
  return fmt::format("{:.7g} Pa, {:.7g} Pa by hand", scene.last.pressure.front(), expected);
}

/// First interval of all: each node is full at zero pressure, none if it has no aperture.
std::string start(const Candidate& candidate) {
  StillScene scene(candidate, water_case(0), straight_slit(nodes, spacing, nodes / 2), rigid);
  double area = 0;
  for (std::size_t i = 0; i < nodes; ++i) {
    scene.asked.aperture[i] = (1 + static_cast<double>(i)) * 1e-5;
    area += scene.driver.network().nodes()[i].lumped_length * scene.asked.aperture[i];
  }
  scene.advance(pumping_time);
  require_ratio("ledger.in_place [m3]", scene.last.ledger.in_place, water::thickness * area, rounding);
  require_ratio("ledger.in_fractures [m3]", scene.last.ledger.in_fractures, water::thickness * area,
                rounding);
  require_close("ledger.injected [m3]", scene.last.ledger.injected, 0, 0);
  const double in_place = scene.last.ledger.in_place;
  std::fill(scene.asked.aperture.begin(), scene.asked.aperture.end(), 3e-4);
  scene.advance(pumping_time);
  require_ratio("ledger.in_place an interval later, wider apart [m3]", scene.last.ledger.in_place, in_place,
                0);
  return fmt::format("in place {:.6g} m3, {:.6g} m3 by hand", in_place, water::thickness * area);
}

}  // namespace

std::vector<Check> storage_checks() {
  return {
      {.name = "storage.start",
       .contract = "flow_solvers.md 3.8",
       .expected = "in_place is the measured aperture of each node at the first interval, and stays that",
       .carry_out = start},
      {.name = "storage.compressibility",
       .contract = contract,
       .expected = "p = K_f V / V_0 in a closed rigid slit",
       .carry_out = compressibility},
      {.name = "storage.compliance",
       .contract = contract,
       .expected = "(a + c p)(1 + p / K_f) = m in a closed slit in a soft rock",
       .carry_out = compliance},
      {.name = "storage.reference_pressure",
       .contract = contract,
       .expected = "the same content stands under another pressure where the reference is another",
       .carry_out = reference_pressure},
      {.name = "storage.closed",
       .contract = "flow_solvers.md 3.6",
       .expected = "faces that touch yield to the pressure above the reference only",
       .carry_out = closed},
      {.name = "storage.aperture_predicted",
       .contract = contract,
       .expected = "aperture_predicted of each node is e(p) of what this interval asks of it",
       .carry_out = aperture_predicted},
      {.name = "storage.never_negative",
       .contract = contract,
       .expected = "e(0) is not below zero, and the pressure is that of (3c)",
       .carry_out = never_negative},
      {.name = "storage.pressed_shut",
       .contract = "flow_solvers.md 3.6",
       .expected = "a node without content below the pressure that lifts its faces has no aperture, stores "
                   "nothing",
       .carry_out = pressed_shut},
      {.name = "storage.aperture_rate",
       .contract = contract,
       .expected = "an aperture that changes at aperture_rate moves the pressure, not the content",
       .carry_out = aperture_rate},
      {.name = "storage.squeezed",
       .contract = contract,
       .expected = "what the rock did otherwise than predicted moves the pressure, never the volume",
       .carry_out = squeezed},
      {.name = "storage.opened",
       .contract = contract,
       .expected = "a node wider than its content has no pressure, filled = m / e(0)",
       .carry_out = opened},
  };
}

}  // namespace fissura::coupler::conformance
