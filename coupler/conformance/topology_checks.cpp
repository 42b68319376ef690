// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "coupler/conformance/driver.hpp"
#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/pumped_slit.hpp"
#include "coupler/conformance/topologies.hpp"

/// What a network is after an insertion: order of arrays, segments, perforations.
namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 5";
constexpr double solution_tolerance = 1e-6;
constexpr double rounding = 1e-12;

/// The order of arrays is that of the network: what is asked of a new node is answered for it.
std::string fills_the_new_node(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance_many(2);
  scene.driver.insert(several_at_once(scene.driver.network(), 2, PumpedSlit::spacing, scene.time));
  constexpr double wide = 5e-4;
  const std::size_t count = scene.driver.network().nodes().size();
  for (std::size_t i = PumpedSlit::nodes; i < count; ++i) {
    CouplingInterval interval = scene.next(1e-3);
    interval.aperture[i] = wide;
    interval.compliance[i] = 0;
    const FlowAnswer answer = scene.driver.advance(interval);
    require_ratio(fmt::format("aperture_predicted of node {}, rigid at {:g} m", i, wide),
                  answer.aperture_predicted[i], wide, 1e-12);
    scene.time = interval.end;
    scene.last.pressure = answer.pressure;
  }
  return fmt::format("aperture_predicted of each of {} new nodes is that of the node it was asked for",
                     count - PumpedSlit::nodes);
}

/// Of each node, what the last interval brought it per area of face, times its length [m2].
std::vector<double> gains(PumpedSlit& scene, const CouplingInterval& interval) {
  const std::vector<double> before = content_of(scene.last, water::bulk_modulus);
  const FlowAnswer answer = scene.driver.advance(interval);
  std::vector<double> gained = content_of(answer, water::bulk_modulus);
  for (std::size_t i = 0; i < gained.size(); ++i) {
    if (i < before.size()) gained[i] -= before[i];
    gained[i] *= scene.driver.network().nodes()[i].lumped_length;
  }
  return gained;
}

constexpr double pumped_area =
    PumpedSlit::rate / water::thickness * PumpedSlit::duration;  // of an interval [m2]
constexpr double narrow_arm = 1e-5, wide_arm = 2e-4;

/// A segment that is removed leaves no gap: arrays of segments are in the order of what is left.
std::string order_of_segments(const Candidate& candidate) {
  constexpr std::size_t removed = 1, well = PumpedSlit::nodes / 2;
  PumpedSlit scene(candidate);
  scene.advance_many(2);
  scene.driver.insert(split_segment(scene.driver.network(), removed, scene.time));
  scene.last.pressure.push_back(scene.last.pressure[removed]);
  scene.advance();
  CouplingInterval interval = scene.next(PumpedSlit::duration);
  const std::size_t segments = scene.driver.network().segments().size();
  interval.arm_aperture_a.assign(segments, narrow_arm);
  interval.arm_aperture_b.assign(segments, narrow_arm);
  const std::size_t to_east =
      well - 1;  // the segment from the well to its east, now that one before it is gone
  interval.arm_aperture_a[to_east] = interval.arm_aperture_b[to_east] = wide_arm;
  const std::vector<double> gained = gains(scene, interval);
  require_within("share of the fluid that goes through the only wide segment, from the well to its east",
                 gained[well + 1] / pumped_area, 0.05, 1);
  require_within("share that goes through narrow arms to its west", gained[well - 1] / pumped_area, -0.01,
                 0.01);
  return fmt::format("{:.0f} % through the wide segment, {:.2g} % through a narrow one",
                     100 * gained[well + 1] / pumped_area, 100 * gained[well - 1] / pumped_area);
}

/// All perforations share one well pressure.
std::string new_perforation(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance_many(2);
  Insertion insertion;
  insertion.revision = 1;
  insertion.new_perforations.push_back({"second", scene.driver.network().nodes().front().id});
  scene.driver.insert(insertion);
  CouplingInterval interval = scene.next(PumpedSlit::duration);
  const std::size_t segments = scene.driver.network().segments().size();
  interval.arm_aperture_a.assign(segments, narrow_arm);
  interval.arm_aperture_b.assign(segments, narrow_arm);
  const std::vector<double> gained = gains(scene, interval);
  double sum = 0;
  for (const double each : gained) sum += each;
  require_ratio("fluid gained by all nodes [m2]", sum, pumped_area, solution_tolerance);
  require_within("share that the new perforation takes", gained.front() / pumped_area, 0.2, 1.5);
  return fmt::format("{:.0f} % of what is pumped goes into the perforation that joined",
                     100 * gained.front() / pumped_area);
}

std::string two_at_a_time(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.driver.insert(tip_growth(scene.driver.network(), PumpedSlit::spacing, 0));
  scene.advance_many(2);
  const double in_place = water::thickness * scene.springs.aperture *
                          integral(scene.driver.network(), std::vector<double>(PumpedSlit::nodes + 1, 1.0));
  require_ratio("ledger.in_place [m3]", scene.last.ledger.in_place, in_place, rounding);
  scene.driver.insert(junction(scene.driver.network(), 2, 2, PumpedSlit::spacing, scene.time));
  scene.driver.insert(tip_growth(scene.driver.network(), PumpedSlit::spacing, scene.time));
  scene.advance_many(2);
  require_close("ledger.residual [m3]", scene.last.ledger.residual(), 0,
                1e-10 * scene.last.ledger.in_fractures);
  require_ratio("ledger.injected [m3]", scene.last.ledger.injected, PumpedSlit::rate * scene.time, 1e-9);
  return fmt::format("revision {}; in place {:.6g} m3, with the node that joined before the first interval",
                     scene.driver.network().revision(), scene.last.ledger.in_place);
}

}  // namespace

std::vector<Check> topology_checks() {
  return {
      {.name = "insertion.order_of_arrays",
       .contract = contract,
       .expected = "arrays are in the order in which nodes were inserted, whatever their ids",
       .carry_out = fills_the_new_node},
      {.name = "insertion.order_of_segments",
       .contract = contract,
       .expected = "arrays of segments are in the order of what is left after removals",
       .physics = {claims::viscous_flow},
       .carry_out = order_of_segments},
      {.name = "insertion.new_perforation",
       .contract = contract,
       .expected = "a perforation that joins shares the well pressure and takes its part of the rate",
       .physics = {claims::viscous_flow},
       .carry_out = new_perforation},
      {.name = "insertion.two_at_a_time",
       .contract = contract,
       .expected =
           "an insertion before the first interval counts as in place; two may come between two intervals",
       .carry_out = two_at_a_time},
  };
}

}  // namespace fissura::coupler::conformance
