// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "common/case/case_json.hpp"
#include "common/errors.hpp"
#include "common/fracture_network/insertion_archive.hpp"
#include "tests/network/flow_setup.hpp"
#include "tests/network/messaged_network.hpp"

using namespace fissura;
using network::test::MessagedNetwork;

namespace {

constexpr std::size_t nodes = 9;

Case leaking_case() {
  Case value;
  value.time.end = 10;
  value.domain = {100, 100, 2};
  value.fluids = {{"water", 1.67e-3, 1, 2e9}};
  value.leak_off = {1e-5, 1e-6};
  value.injection.well_index = 1e-5;
  value.injection.stages = {{.begin = 0, .rate = 2e-4, .ramp = 3, .fluid = "water"}};
  value.network = {1e-5, 1e-10, 100};
  return value;
}

Message advance_command(double begin, double end) {
  Message command(MessageType::advance);
  command.body = {{"begin", begin}, {"end", end}, {"carry", "content"}};
  command.add("aperture", "m", std::vector<double>(nodes, 1e-4));
  command.add("aperture_rate", "m/s", std::vector<double>(nodes, 0.0));
  command.add("reference_pressure", "Pa", std::vector<double>(nodes, 1e6));
  command.add("compliance", "m/Pa", std::vector<double>(nodes, 1e-11));
  command.add("closed", "1", std::vector<double>(nodes, 0.0));
  return command;
}

void join(MessagedNetwork& solver) {
  solver.join({case_to_json(leaking_case()), 1});
}

std::vector<Insertion> insertions() {
  return {network::test::straight_fracture(nodes, 0.5, {4})};
}

Message neutral_state_of(MessagedNetwork& solver) {
  Message state(MessageType::state);
  solver.describe_neutral_state(state);
  return state;
}

}  // namespace

TEST_CASE("a neutral state brings content, leaked volume, ledger and the well to another process",
          "[flow_solver]") {
  MessagedNetwork first, second;
  join(first);
  (void)first.insert(insertions().front());
  for (int k = 0; k < 10; ++k) (void)first.advance(advance_command(0.1 * k, 0.1 * (k + 1)));
  const Message state = neutral_state_of(first);
  join(second);
  CHECK(second.take_up(state, insertions()) == network_after(insertions()).topology_hash());
  const Message again = neutral_state_of(second);
  for (const char* name : {"neutral_content", "neutral_leaked", "neutral_pressure", "neutral_exposure_time"})
    CHECK(again.numbers(name, nodes) == state.numbers(name, nodes));
  for (const char* volume : {"injected", "in_place", "leaked", "in_fractures"})
    CHECK(again.body["neutral"]["ledger"][volume].get<double>() ==
          Approx(state.body["neutral"]["ledger"][volume].get<double>()).epsilon(1e-14));

  const Message expected = first.advance(advance_command(0.1 * 10, 1.1));
  const Message found = second.advance(advance_command(0.1 * 10, 1.1));
  CHECK(found.body["rate"].get<double>() == Approx(expected.body["rate"].get<double>()).epsilon(1e-13));
  const std::vector<double> p = expected.numbers("pressure", nodes), q = found.numbers("pressure", nodes);
  // Only what leak-off was owed differs.
  for (std::size_t i = 0; i < nodes; ++i) CHECK(q[i] == Approx(p[i]).epsilon(1e-3));
  const nlohmann::json& ledger = found.body["ledger"];
  CHECK(std::abs(ledger["residual"].get<double>()) < 1e-13 * ledger["injected"].get<double>());
}

TEST_CASE("a neutral state that does not fit the topology or lacks a part is refused", "[flow_solver]") {
  MessagedNetwork first, second;
  join(first);
  (void)first.insert(insertions().front());
  (void)first.advance(advance_command(0, 0.1));
  join(second);
  Message state = neutral_state_of(first);
  CHECK_THROWS_AS(second.take_up(state, {network::test::straight_fracture(nodes + 1, 0.5, {4})}),
                  ProtocolError);
  state.body["neutral"].erase("ledger");
  CHECK_THROWS_WITH(second.take_up(state, insertions()), Catch::Contains("ledger"));
}
