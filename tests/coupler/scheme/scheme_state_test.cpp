// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/scheme_state.hpp"

#include <catch2/catch.hpp>

#include "common/errors.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

constexpr double run_end = 10;

Case some_case() {
  Case run_case;
  run_case.mesh.fracture_size = 0.5;
  run_case.coupling.minimum_steps = 10;
  run_case.coupling.maximum_steps = 100;
  run_case.coupling.drift_tolerance = 1e-3;
  return run_case;
}

Insertion chain_of_three() {
  Insertion first;
  first.revision = 0;
  for (const NodeId id : {10, 11, 12})
    first.new_nodes.push_back({id, 0.1 * double(id), 0, 0.5, 1, NodeRole::interior, 0, false, 0, 0});
  first.new_segments = {{20, 10, 11, 1, SegmentKind::hydraulic, 0.5},
                        {21, 11, 12, 1, SegmentKind::hydraulic, 0.5}};
  return first;
}

Insertion one_more() {
  Insertion next;
  next.revision = 1;
  next.new_nodes.push_back({13, 1.0 / 3, 0, 0.5, 1, NodeRole::tip, 0.7, true, 1e6, 1e-12});
  next.new_segments = {{22, 12, 13, 1, SegmentKind::hydraulic, 0.1}};
  return next;
}

std::vector<double> four(double value) {
  return {value, value / 3, -0.0, 5e-324};
}

/// After a few intervals and an insertion, with values that no decimal text of few digits gives back.
SchemeState some_state() {
  SchemeState state(some_case(), run_end);
  for (const Insertion& insertion : {chain_of_three(), one_more()}) {
    state.network.apply(insertion);
    state.insertions.push_back(insertion);
  }
  state.interval_control.start(1e-3);
  for (int k = 1; k <= 12; ++k) {
    const ClockInterval interval = state.clock.next(state.interval_control.proposal(), run_end);
    state.clock.commit(interval);
    state.interval_control.observe({interval.end, 1e-4 / k, 1e-3, 2 + 0.5 * (k / 2), false});
  }
  state.structure.aperture = four(1e-3);
  state.structure.aperture_rate = four(1e-5);
  state.structure.pressure_applied = four(1e7);
  state.structure.pressure_opening = four(2e7);
  state.structure.closed = four(0);
  state.structure.broken = four(1);
  state.structure.arm_aperture_a = {1e-4, 2e-4, 3e-4};
  state.structure.arm_aperture_b = {4e-4, 5e-4, 6e-4};
  state.structure.stable_step = 1e-3 / 7;
  state.structure.mass_scale = 17.3;
  state.network_pressure = four(1.1e7);
  state.average_rate = four(3e-6);
  state.strain_energy = 1e5 / 3;
  state.reports = 4;
  return state;
}

}  // namespace

TEST_CASE("a restored scheme proposes the same intervals and has the same interface, bit for bit",
          "[coupler][scheme][checkpoint]") {
  const SchemeState saved = some_state();
  SchemeState restored(some_case(), run_end);
  restore(save(saved), restored);

  CHECK(save(restored) == save(saved));
  CHECK(restored.clock.index() == 12);
  CHECK(restored.clock.time() == saved.clock.time());
  CHECK(restored.network.topology_hash() == saved.network.topology_hash());
  CHECK(restored.network.nodes() == saved.network.nodes());
  CHECK(restored.insertions == saved.insertions);
  CHECK(restored.reports == 4);
  CHECK(difference(saved.structure, restored.structure).empty());
  CHECK(restored.network_pressure == saved.network_pressure);

  SchemeState a = saved, b = restored;
  for (int k = 1; k <= 20; ++k) {
    for (SchemeState* state : {&a, &b}) {
      const ClockInterval interval = state->clock.next(state->interval_control.proposal(), run_end);
      state->clock.commit(interval);
      state->interval_control.observe({interval.end, 1e-3, 1e-3, 8 + 0.5 * (k / 3), k == 15});
    }
    CHECK(a.interval_control.proposal() == b.interval_control.proposal());
    CHECK(a.interval_control.front_speed() == b.interval_control.front_speed());
  }
}

TEST_CASE("a structure that describes another interface is found out, even by the sign of a zero",
          "[coupler][scheme][checkpoint]") {
  const SchemeState state = some_state();
  StructureResponse other = state.structure;
  CHECK(difference(state.structure, other).empty());
  other.pressure_opening[2] = 0.0;
  CHECK(difference(state.structure, other) == "pressure_opening");
  other = state.structure;
  other.arm_aperture_b.pop_back();
  CHECK(difference(state.structure, other) == "arm_aperture_b");
}

TEST_CASE("bytes that are no saved scheme are refused, and the state is as it was",
          "[coupler][scheme][checkpoint]") {
  const std::vector<std::byte> good = save(some_state());
  const auto refused = [&](const std::vector<std::byte>& bytes) {
    SchemeState state = some_state();
    try {
      restore(bytes, state);
    } catch (const Error& error) {
      CHECK(error.code() == ExitCode::checkpoint_unusable);
      return save(state) == good;
    }
    return false;
  };
  CHECK(refused({}));
  for (std::size_t length = 0; length < good.size(); length += 13)
    CHECK(refused({good.begin(), good.begin() + static_cast<long>(length)}));
  std::vector<std::byte> longer = good;
  longer.push_back({});
  CHECK(refused(longer));
  std::vector<std::byte> other_format = good;
  other_format[0] ^= std::byte{2};
  CHECK(refused(other_format));
}
