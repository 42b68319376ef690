// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/fault_point.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>

#include "common/errors.hpp"

using namespace fissura;

namespace {

/// FISSURA_FAULT for the length of one test.
class FaultInEnvironment {
 public:
  explicit FaultInEnvironment(const char* text) { ::setenv("FISSURA_FAULT", text, 1); }
  ~FaultInEnvironment() { ::unsetenv("FISSURA_FAULT"); }
  FaultInEnvironment(const FaultInEnvironment&) = delete;
  FaultInEnvironment& operator=(const FaultInEnvironment&) = delete;
};

}  // namespace

TEST_CASE("a fault plan names who fails, in which interval, and how", "[common][exchange]") {
  const FaultPlan plan = parse_fault_plan("structure@40=spin");
  CHECK(plan.role == "structure");
  CHECK(plan.interval == 40);
  CHECK(plan.kind == FaultKind::spin);
  CHECK(parse_fault_plan("network@0=kill").kind == FaultKind::kill);
  CHECK(parse_fault_plan("network@1=stop").kind == FaultKind::stop);
  CHECK(parse_fault_plan("network@2=fail").kind == FaultKind::fail);
  CHECK(parse_fault_plan("network@3=exit").kind == FaultKind::exit);
  CHECK(parse_fault_plan("coupler@18446744073709551615=nan").interval == UINT64_MAX);
}

TEST_CASE("a fault plan that cannot be meant is refused with itself and what was expected",
          "[common][exchange]") {
  const char* text =
      GENERATE("", "structure", "structure@40", "structure=spin", "structure=40@spin", "rock@40=spin",
               "structure@=spin", "structure@-1=spin", "structure@4x=spin", "structure@40=explode",
               "structure@40=", "structure@18446744073709551616=spin", " structure@40=spin");
  CAPTURE(text);
  CHECK_THROWS_AS(parse_fault_plan(text), InputError);
  CHECK_THROWS_WITH(parse_fault_plan(text), Catch::Contains(std::string("\"") + text + "\"") &&
                                                Catch::Contains("ROLE@INTERVAL=KIND"));
}

TEST_CASE("a fault plan of the environment speaks to its own role only", "[common][exchange]") {
  CHECK_FALSE(fault_plan_of_environment("structure").has_value());
  const FaultInEnvironment environment("network@7=nan");
  CHECK_FALSE(fault_plan_of_environment("structure").has_value());
  REQUIRE(fault_plan_of_environment("network").has_value());
  CHECK(fault_plan_of_environment("network")->interval == 7);
}

TEST_CASE("a fault strikes in its interval and in no other", "[common][exchange]") {
  CHECK_FALSE(fault_point(std::nullopt, 7));
  const FaultPlan spoilt = parse_fault_plan("network@7=nan"), failing = parse_fault_plan("network@7=fail");
  CHECK_FALSE(fault_point(spoilt, 6));
  CHECK(fault_point(spoilt, 7));
  CHECK_FALSE(fault_point(spoilt, 8));
  CHECK_FALSE(fault_point(failing, 6));
  CHECK_THROWS_AS(fault_point(failing, 7), SolverError);
}
