// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "coupler/conformance/driver.hpp"
#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/refusal.hpp"
#include "coupler/conformance/topologies.hpp"
#include "coupler/faults/forgery.hpp"

namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 2.1";

std::string hello(const Candidate& candidate) {
  Driver driver(candidate);
  const Greeting& greeting = driver.greeting();
  require_same("role", greeting.role, "network");
  require(!greeting.solver.empty() && !greeting.version.empty(), "names of solver and version",
          fmt::format("\"{}\", \"{}\"", greeting.solver, greeting.version));
  require(greeting.pid > 0, "a process id", fmt::format("{}", greeting.pid));
  return fmt::format("{} {}, process {}", greeting.solver, greeting.version, greeting.pid);
}

}  // namespace

std::vector<Check> handshake_checks() {
  return {
      {.name = "handshake.hello",
       .contract = contract,
       .expected = "HELLO comes first, with role network, solver, version, pid and capabilities",
       .carry_out = hello},
  };
}

}  // namespace fissura::coupler::conformance
