// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/faults/fault_plan.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "common/errors.hpp"
#include "tests/coupler/temporary_directory.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

FaultPlan plan_of(const char* text) {
  const sample::TemporaryDirectory directory;
  const std::filesystem::path file = directory.path() / "plan.toml";
  std::ofstream(file) << text;
  return read_fault_plan(file);
}

}  // namespace

TEST_CASE("a plan holds faults of processes and of messages, and says whose messages pass through a proxy",
          "[coupler][faults]") {
  const FaultPlan plan = plan_of(R"(
[[fault]]
role = "structure"
phase = "advance"
do = "kill"
[[message]]
role = "network"
direction = "to_coupler"
type = "PRESSURE"
interval = 17
occurrence = 3
epoch = "every"
do = "poison"
field = "pressure"
index = 5
value = nan
[[message]]
role = "network"
direction = "to_participant"
do = "restamp"
stamp = "sequence"
shift = -1
)");
  CHECK(plan.processes.size() == 1);
  REQUIRE(plan.messages.size() == 2);
  const MessageFault& poison = plan.messages[0];
  CHECK(poison.direction == Direction::to_coupler);
  CHECK(poison.type == MessageType::pressure);
  CHECK(poison.interval == 17);
  CHECK(poison.occurrence == 3);
  CHECK_FALSE(poison.epoch.has_value());
  CHECK(poison.field == "pressure");
  CHECK(poison.index == 5);
  CHECK(std::isnan(poison.value));
  CHECK_FALSE(plan.messages[1].type.has_value());
  CHECK(plan.messages[1].shift == -1);
  CHECK(plan.relays("network"));
  CHECK_FALSE(plan.relays("structure"));
  CHECK(plan_of("transcript = true").relays("structure"));
}

TEST_CASE("a whole number in a plan is read as one, or refused", "[coupler][faults]") {
  const auto with = [](const std::string& details) {
    const std::string text = "[[message]]\nrole = \"network\"\ndirection = \"to_coupler\"\n" + details;
    return plan_of(text.c_str());
  };
  const auto [details, told] = GENERATE(table<std::string, std::string>(
      {{"do = \"restamp\"\nstamp = \"sequence\"\nshift = \"structure\"", "message[0].shift: found \"structure\""},
       {"do = \"restamp\"\nstamp = \"sequence\"\nshift = 1.5", "message[0].shift: found 1.5"},
       {"do = \"resize\"\nfield = \"pressure\"\nlength = nan", "message[0].length: found nan"},
       {"do = \"oversize\"\nbytes = -1", "message[0].bytes: found -1"},
       {"do = \"nonsense\"", "message[0].bytes: found nothing"}}));
  CHECK_THROWS_WITH(with(details), Catch::Contains(told));
}

TEST_CASE("everything wrong with a plan is told at once", "[coupler][faults]") {
  const char* text = R"([[message]]
role = "coupler"
direction = "back"
type = "PRESURE"
do = "flip"
frame = -1
bits = 3
[[message]]
role = "network"
direction = "to_coupler"
do = "delay"
[[message]]
role = "network"
direction = "to_coupler"
do = "poison"
entry = "ledger"
value = "much"
[[fault]]
role = "network"
phase = "advance"
do = "explode"
[extra]
)";
  const char* told = GENERATE(
      ":2:8: message[0].role: found \"coupler\", expected one of structure, network",
      ":3:13: message[0].direction: found \"back\", expected one of to_participant, to_coupler",
      "message[0].type: found \"PRESURE\"", "did you mean \"PRESSURE\"?", "message[0].frame: found -1",
      "message[0].bits: found an unknown key", "did you mean \"bit\"?", "message[1].seconds: found nothing",
      "message[2].entry", "message[2].value: found \"much\", expected a number",
      "fault[0].do: found \"explode\"", "extra: found an unknown key", "10 things");
  CHECK_THROWS_AS(plan_of(text), InputError);
  CHECK_THROWS_WITH(plan_of(text), Catch::Contains(told));
}
