// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

/// Fault injection at coupling intervals, for tests of the coupling (docs/operation.md).
namespace fissura {

enum class FaultKind { kill, stop, spin, fail, exit, nan };

/// "ROLE@INTERVAL=KIND", e.g. "structure@40=spin"; ROLE is structure, network or coupler.
struct FaultPlan {
  std::string role;
  std::uint64_t interval = 0;
  FaultKind kind = FaultKind::kill;
};

/// Throws InputError naming the fault and what was expected.
FaultPlan parse_fault_plan(const std::string& text);

/// The plan in the environment variable FISSURA_FAULT, if it is set and speaks of `role`.
std::optional<FaultPlan> fault_plan_of_environment(const std::string& role);

/// Does what `plan` says if `interval` has come: SIGKILL or SIGSTOP to oneself, an endless loop, a SolverError, or _exit(0).
/// Returns true if the plan is `nan` and the values about to be sent must be spoilt.
bool fault_point(const std::optional<FaultPlan>& plan, std::uint64_t interval);

}  // namespace fissura
