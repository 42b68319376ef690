// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <limits>

#include "common/errors.hpp"
#include "coupler/checkpoint/neutral_network.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

NeutralFlowState two_nodes_of_two_fluids() {
  NeutralFlowState state;
  state.time = 1.0 / 3;
  state.started = true;
  state.content = {1e-3 / 7, -1e-30};
  state.pressure = {5e6, 0};
  state.leaked = {1e-6, 2e-6};
  state.exposure_time = {0.1, std::numeric_limits<double>::infinity()};
  state.contact_pressure = {0, 1e5};
  state.fluid_fraction = {0.25, 0.75, 1, 0};
  state.joining = {0, 1};
  state.well_pressure = 6e6;
  state.rate = 0.01;
  state.entry_rate = 0.02;
  state.entry_pressure = 3e6;
  state.ledger = {.injected = 1, .in_place = 2, .found = 3, .in_fractures = 4, .leaked = 5, .reset = 6};
  return state;
}

}  // namespace

TEST_CASE("the neutral state of a network comes back from a checkpoint with every bit",
          "[coupler][checkpoint]") {
  const NeutralFlowState state = two_nodes_of_two_fluids();
  const auto part = neutral_part(state);
  const NeutralFlowState back = neutral_state_of(part, 2, 2);
  CHECK(neutral_part(back) == part);
  CHECK(back.content == state.content);
  CHECK(back.exposure_time == state.exposure_time);
  CHECK(back.fluid_fraction == state.fluid_fraction);
  CHECK(back.joining == state.joining);
  CHECK(back.entry_pressure == state.entry_pressure);
  CHECK(back.ledger.residual() == state.ledger.residual());
}

TEST_CASE("a neutral state of another network, of other fluids, cut short or lengthened is refused",
          "[coupler][checkpoint]") {
  auto part = neutral_part(two_nodes_of_two_fluids());
  CHECK_THROWS_AS(neutral_state_of(part, 3, 2), Error);
  CHECK_THROWS_AS(neutral_state_of(part, 2, 1), Error);
  for (std::size_t length = 0; length < part.size(); ++length)
    CHECK_THROWS_AS(neutral_state_of(std::span(part).first(length), 2, 2), Error);
  part.push_back({});
  CHECK_THROWS_AS(neutral_state_of(part, 2, 2), Error);
}
