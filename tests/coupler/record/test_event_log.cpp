// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "coupler/record/event_log.hpp"
#include "tests/coupler/record/sample_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

TEST_CASE("every event is on disk as one JSON object before the log is closed", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  EventLog log(folder.path() / "log.jsonl");
  log.add({7, 0.25, EventLevel::warn, "network", "halving", "the interval was \"halved\"\nonce"});
  log.add({8, 0.5, EventLevel::info, "coupler", "topology", "revision 1"});

  const auto lines = sample::lines(folder.path() / "log.jsonl");
  REQUIRE(lines.size() == 2);
  const auto event = nlohmann::json::parse(lines[0]);
  CHECK(event["interval"] == 7);
  CHECK(event["time"] == 0.25);
  CHECK(event["level"] == "warn");
  CHECK(event["participant"] == "network");
  CHECK(event["event"] == "halving");
  CHECK(event["text"] == "the interval was \"halved\"\nonce");
  CHECK(event["wall"].get<double>() <= nlohmann::json::parse(lines[1])["wall"].get<double>());
}

TEST_CASE("a text that is not UTF-8 does not end the log", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  EventLog log(folder.path() / "log.jsonl");
  log.add({0, 0, EventLevel::error, "structure", "fail", "bad byte \xff here"});
  CHECK_NOTHROW(nlohmann::json::parse(sample::lines(folder.path() / "log.jsonl").at(0)));
}

TEST_CASE("a log that cannot be created says which file and why", "[coupler][record]") {
  REQUIRE_THROWS_WITH(EventLog("/nonexistent/log.jsonl"),
                      Catch::Contains("/nonexistent/log.jsonl") && Catch::Contains("No such file"));
}
