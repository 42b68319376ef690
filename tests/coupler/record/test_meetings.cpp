// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "coupler/record/meetings.hpp"
#include "tests/coupler/record/sample_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

nlohmann::json entry(bool crosses) {
  return {{"time", 2.5},
          {"x", 4.5},
          {"y", -0.25},
          {"hydraulic", "slit"},
          {"natural", "set, 7"},
          {"angle", 1.0},
          {"stress_xx", -15e6},
          {"stress_yy", -10e6},
          {"stress_xy", 2e5},
          {"friction", 0.6},
          {"cohesion", 1e5},
          {"strength", 2e6},
          {"criterion", "gu_weng"},
          {"critical_friction", 0.375},
          {"crosses", crosses}};
}

}  // namespace

TEST_CASE("meetings.csv has one line for each decision, with the numbers it was made from",
          "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  MeetingLedger ledger(folder.path());
  ledger.add(12, meeting_from_json(entry(true)));
  nlohmann::json never = entry(false);
  never["critical_friction"] = nullptr;
  ledger.add(13, meeting_from_json(never));
  ledger.flush();
  const auto lines = sample::lines(folder.path() / "meetings.csv");
  REQUIRE(lines.size() == 3);
  CHECK(lines[0] ==
        "revision,time,x,y,hydraulic,natural,angle,stress_xx,stress_yy,stress_xy,friction,cohesion,strength,"
        "criterion,"
        "critical_friction,crosses");
  CHECK(lines[1] ==
        "12,2.5,4.5,-0.25,slit,\"set, 7\",1,-15000000,-10000000,200000,0.6,100000,2000000,gu_weng,0.375,1");
  CHECK(lines[2] ==
        "13,2.5,4.5,-0.25,slit,\"set, 7\",1,-15000000,-10000000,200000,0.6,100000,2000000,gu_weng,nan,0");
  CHECK(ledger.totals().met == 2);
  CHECK(ledger.totals().crossed == 1);
}

TEST_CASE("a run without a meeting has no meetings.csv", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  MeetingLedger ledger(folder.path());
  ledger.flush();
  CHECK_FALSE(std::filesystem::exists(folder.path() / "meetings.csv"));
  CHECK(ledger.totals().met == 0);
}

TEST_CASE("the event of a meeting says what was decided and from which friction it would have been otherwise",
          "[coupler][record]") {
  CHECK(sentence(meeting_from_json(entry(true))) ==
        "\"slit\" meets \"set, 7\" at (4.5, -0.25) m at 57.3 degrees and may cross: friction 0.6, would "
        "cross from a "
        "friction of 0.375 by gu_weng");
}

TEST_CASE("a meeting that lacks a number is refused", "[coupler][record]") {
  nlohmann::json incomplete = entry(true);
  incomplete.erase("angle");
  CHECK_THROWS_WITH(meeting_from_json(incomplete), Catch::Contains("angle"));
  CHECK_THROWS_AS(meeting_from_json(incomplete), ProtocolError);
  nlohmann::json wrong = entry(true);
  wrong["crosses"] = "yes";
  CHECK_THROWS_AS(meeting_from_json(wrong), ProtocolError);
}
