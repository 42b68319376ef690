// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/exchange/channel.hpp"

namespace fissura::coupler::conformance {

/// The flow solver under test.
struct Candidate {
  std::string command;      ///< shell command; `--connect ENDPOINT` is appended
  Seconds patience{10};     ///< for any answer
  std::uint32_t epoch = 0;  ///< how often the run in which it takes part has been resumed
};

/// Thrown by a check where the contract is not kept.
class Deviation : public std::runtime_error {
 public:
  /// Both in words and numbers: "content of node 3 is 1e-4 m", "2e-4 m".
  Deviation(std::string expected, std::string obtained)
      : std::runtime_error("expected " + expected + ", obtained " + obtained),
        expected_(std::move(expected)),
        obtained_(std::move(obtained)) {}
  [[nodiscard]] const std::string& expected() const { return expected_; }
  [[nodiscard]] const std::string& obtained() const { return obtained_; }

 private:
  std::string expected_, obtained_;
};

/// One promise of the contract, tried.
struct Check {
  std::string name;      ///< "SUBJECT.WHAT"
  std::string contract;  ///< where it is promised: "flow_solvers.md 3.4"
  std::string expected;  ///< in one sentence
  /// What the solver must claim, else the check does not apply: physics (common/flow_solver, `claims`) and
  /// capabilities of HELLO.
  std::set<std::string> physics = {}, capabilities = {};
  /// @returns what was obtained, in words and numbers. Throws Deviation; Error counts as one.
  std::function<std::string(const Candidate&)> carry_out;
};

/// All checks, in the order in which they are carried out.
std::vector<Check> all_checks();

// One function for each file of checks.
std::vector<Check> handshake_checks();
std::vector<Check> order_checks();
std::vector<Check> insertion_checks();
std::vector<Check> topology_checks();
std::vector<Check> report_checks();
std::vector<Check> state_checks();
std::vector<Check> neutral_checks();
std::vector<Check> damage_checks();
std::vector<Check> deadline_checks();

}  // namespace fissura::coupler::conformance
