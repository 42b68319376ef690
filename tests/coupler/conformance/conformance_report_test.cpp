// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/conformance/conformance_report.hpp"

#include <catch2/catch.hpp>

using namespace fissura::coupler::conformance;

namespace {

ConformanceResult some_result() {
  ConformanceResult result;
  result.greeting = {.role = "network",
                     .solver = "example",
                     .version = "2",
                     .pid = 7,
                     .capabilities = {"save"},
                     .physics = std::set<std::string>{"leak_off"}};
  result.outcomes = {{.name = "a.one",
                      .contract = "flow_solvers.md 5",
                      .promise = "x is kept",
                      .expected = "x: 1",
                      .obtained = "2",
                      .verdict = Verdict::failed,
                      .seconds = 0.25},
                     {.name = "a.two",
                      .contract = "flow_solvers.md 6.1",
                      .promise = "y",
                      .expected = "y",
                      .obtained = "done",
                      .verdict = Verdict::passed,
                      .seconds = 0.5},
                     {.name = "b.one",
                      .contract = "flow_solvers.md 3.5",
                      .promise = "z",
                      .expected = "z",
                      .obtained = "the solver does not claim power_law",
                      .verdict = Verdict::not_claimed,
                      .seconds = 0}};
  return result;
}

}  // namespace

TEST_CASE(
    "conformance report: a failure says what was expected, what was obtained, and where the contract says so",
    "[coupler][conformance]") {
  const std::string lines = lines_of(some_result().outcomes[0]);
  CHECK(lines.starts_with("FAILED"));
  for (const char* part : {"a.one", "promise   x is kept\n", "expected  x: 1\n", "obtained  2\n",
                           "contract  flow_solvers.md 5\n"})
    CHECK(lines.find(part) != std::string::npos);
}

TEST_CASE("conformance report: what passed takes one line, however much it says", "[coupler][conformance]") {
  Outcome outcome = some_result().outcomes[1];
  outcome.obtained = std::string(500, 'w') + "\u00e9";
  const std::string line = lines_of(outcome);
  CHECK(line.find('\n') == line.size() - 1);
  CHECK(line.size() < 170);
}

TEST_CASE("conformance report: the JSON counts verdicts and tells apart no claims from claims of nothing",
          "[coupler][conformance]") {
  ConformanceResult result = some_result();
  const nlohmann::json report = report_json(result, "./solver");
  CHECK(report["passed"] == 1);
  CHECK(report["failed"] == 1);
  CHECK(report["not_claimed"] == 1);
  CHECK(report["command"] == "./solver");
  CHECK(report["physics"] == nlohmann::json::array({"leak_off"}));
  CHECK(report["checks"][0]["verdict"] == "failed");
  CHECK(report["checks"][2]["verdict"] == "not_claimed");
  result.greeting.physics.reset();
  CHECK(report_json(result, "./solver")["physics"].is_null());
  CHECK(closing(result) == "3 checks: 1 passed, 1 failed, 1 not claimed, in 0.8 s\n");
}
