// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <regex>
#include <set>

#include "common/flow_solver/flow_solver.hpp"
#include "coupler/conformance/check.hpp"
#include "coupler/conformance/conformance_run.hpp"

using namespace fissura;
using namespace fissura::coupler::conformance;

TEST_CASE("conformance kit: every check has a name of its own, its place in the contract, and an expectation",
          "[coupler][conformance]") {
  const std::set<std::string> known_physics{
      claims::viscous_flow,     claims::leak_off,          claims::power_law,     claims::several_fluids,
      claims::pressure_control, claims::natural_fractures, claims::carry_pressure};
  const std::set<std::string> known_capabilities{"insert", "report", "save", "restore", "neutral_state"};
  std::set<std::string> names;
  for (const Check& check : all_checks()) {
    CAPTURE(check.name);
    CHECK(names.insert(check.name).second);
    CHECK(std::regex_match(check.name, std::regex("[a-z_]+\\.[a-z0-9_]+")));
    CHECK(std::regex_match(check.contract, std::regex("flow_solvers\\.md [1-9](\\.[1-9])?")));
    CHECK_FALSE(check.expected.empty());
    CHECK(check.carry_out);
    for (const std::string& claim : check.physics) CHECK(known_physics.contains(claim));
    for (const std::string& capability : check.capabilities) CHECK(known_capabilities.contains(capability));
  }
  CHECK(names.size() >= 40);
}

namespace {

std::vector<Check> three_checks() {
  return {{.name = "insertion.tip", .contract = "flow_solvers.md 5", .expected = "a", .carry_out = {}},
          {.name = "insertion.junction", .contract = "flow_solvers.md 5", .expected = "b", .carry_out = {}},
          {.name = "insertions.other", .contract = "flow_solvers.md 5", .expected = "c", .carry_out = {}}};
}

}  // namespace

TEST_CASE("conformance kit: checks are selected by name, by subject, and by pattern",
          "[coupler][conformance]") {
  CHECK(selected(three_checks(), "*").size() == 3);
  CHECK(selected(three_checks(), "insertion").size() == 2);
  CHECK(selected(three_checks(), "insertion.tip").size() == 1);
  CHECK(selected(three_checks(), "*tion.t*").size() == 1);
  CHECK(selected(three_checks(), "tip").empty());
}

TEST_CASE("conformance kit: a program that does not say HELLO is told of as such", "[coupler][conformance]") {
  CHECK_THROWS_WITH(run_conformance({.command = "/bin/false", .patience = Seconds(5)}, {}, {}),
                    Catch::Contains("HELLO") && Catch::Contains("exit code 1"));
}
