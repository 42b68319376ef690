// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/faults/process_fault.hpp"

/// The points at which a process may be made to fail. Without a plan a point costs one comparison.
namespace fissura {

/// Arms this process with the faults that the environment plans for `role`: of the plan in the file
/// FISSURA_FAULT_PLAN and of the short spelling FISSURA_FAULT, in the epoch FISSURA_EPOCH (0 without it).
/// Throws InputError with everything that is wrong with the plan.
void arm_planned_faults(std::string_view role);

/// The same with the faults at hand; none disarms the process.
void arm_faults(std::vector<ProcessFault> faults);

/// A value of the reply about to be sent that must be spoilt.
struct Spoil {
  std::string field;        ///< name of the array; empty: the first one of numbers
  std::uint64_t index = 0;  ///< of the value in it
  FaultAction how = FaultAction::nan;
};

namespace armed {
extern bool any;
std::optional<Spoil> strike(FaultPhase phase, std::uint64_t interval);
std::optional<Spoil> strike(const char* phase, std::uint64_t interval);
std::optional<Spoil> strike(FaultPhase phase);
}  // namespace armed

/// The process enters `phase` of `interval`: does what its plan says for that, and may never return.
inline std::optional<Spoil> fault_point(FaultPhase phase, std::uint64_t interval) {
  return armed::any ? armed::strike(phase, interval) : std::nullopt;
}

/// The same by the name of the phase; nothing of a name that is none.
inline std::optional<Spoil> fault_point(const char* phase, std::uint64_t interval) {
  return armed::any ? armed::strike(phase, interval) : std::nullopt;
}

/// The same in the interval of the last point, for code that does not know of intervals.
inline void fault_point(FaultPhase phase) {
  if (armed::any) (void)armed::strike(phase);
}

enum class StorageCall { write, sync, rename };

/// The error number with which the call about to be made must fail; 0: it may be made.
int injected_error(StorageCall call);

}  // namespace fissura
