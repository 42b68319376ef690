// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/case/names.hpp"
#include "common/case/table_reader.hpp"

/// What a fault plan makes a process do at a named point of its work (docs/operation.md, "Injecting faults").
namespace fissura {

/// Points of participants, then points of the coupler; a phase is entered when its work begins, `answer`
/// before a reply is sent.
enum class FaultPhase {
  hello,
  join,
  insert,
  advance,
  answer,
  report,
  save,
  restore,
  finish,
  start,
  network,
  structure,
  insertion,
  segment,
  checkpoint_prepare,
  checkpoint_commit,
  resume
};

enum class FaultAction {
  kill,             ///< SIGKILL to oneself
  stop,             ///< SIGSTOP to oneself
  stop_for,         ///< the same, and SIGCONT after `seconds`
  sleep,            ///< works at nothing for `seconds`
  spin,             ///< endless loop
  fail,             ///< SolverError: a failure that a solver tells of itself
  throw_exception,  ///< an exception that nobody planned
  exit,             ///< leaves with exit code `code`
  abort,
  segfault,
  exhaust,          ///< takes all memory that a limit on its address space leaves it
  round_up,         ///< leaves floating-point arithmetic rounding upward
  flush_denormals,  ///< leaves it replacing denormal numbers by zero
  nan,              ///< participants, `answer`: a value of the reply becomes not-a-number
  negative,         ///< the same: less than 0
  disk_full,        ///< coupler: every write from now on fails
  write_error,      ///< coupler: the next write fails, ...
  sync_error,       ///< ... the next fsync
  rename_error      ///< ... the next rename
};

inline constexpr std::array fault_phases{
    Named<FaultPhase>{"hello", FaultPhase::hello},
    Named<FaultPhase>{"join", FaultPhase::join},
    Named<FaultPhase>{"insert", FaultPhase::insert},
    Named<FaultPhase>{"advance", FaultPhase::advance},
    Named<FaultPhase>{"answer", FaultPhase::answer},
    Named<FaultPhase>{"report", FaultPhase::report},
    Named<FaultPhase>{"save", FaultPhase::save},
    Named<FaultPhase>{"restore", FaultPhase::restore},
    Named<FaultPhase>{"finish", FaultPhase::finish},
    Named<FaultPhase>{"start", FaultPhase::start},
    Named<FaultPhase>{"network", FaultPhase::network},
    Named<FaultPhase>{"structure", FaultPhase::structure},
    Named<FaultPhase>{"insertion", FaultPhase::insertion},
    Named<FaultPhase>{"segment", FaultPhase::segment},
    Named<FaultPhase>{"checkpoint-prepare", FaultPhase::checkpoint_prepare},
    Named<FaultPhase>{"checkpoint-commit", FaultPhase::checkpoint_commit},
    Named<FaultPhase>{"resume", FaultPhase::resume}};

inline constexpr std::array fault_actions{Named<FaultAction>{"kill", FaultAction::kill},
                                          Named<FaultAction>{"stop", FaultAction::stop},
                                          Named<FaultAction>{"stop_for", FaultAction::stop_for},
                                          Named<FaultAction>{"sleep", FaultAction::sleep},
                                          Named<FaultAction>{"spin", FaultAction::spin},
                                          Named<FaultAction>{"fail", FaultAction::fail},
                                          Named<FaultAction>{"throw", FaultAction::throw_exception},
                                          Named<FaultAction>{"exit", FaultAction::exit},
                                          Named<FaultAction>{"abort", FaultAction::abort},
                                          Named<FaultAction>{"segfault", FaultAction::segfault},
                                          Named<FaultAction>{"exhaust", FaultAction::exhaust},
                                          Named<FaultAction>{"round_up", FaultAction::round_up},
                                          Named<FaultAction>{"flush_denormals", FaultAction::flush_denormals},
                                          Named<FaultAction>{"nan", FaultAction::nan},
                                          Named<FaultAction>{"negative", FaultAction::negative},
                                          Named<FaultAction>{"disk_full", FaultAction::disk_full},
                                          Named<FaultAction>{"write_error", FaultAction::write_error},
                                          Named<FaultAction>{"sync_error", FaultAction::sync_error},
                                          Named<FaultAction>{"rename_error", FaultAction::rename_error}};

struct ProcessFault {
  std::string role;                       ///< "structure", "network" or "coupler"
  std::optional<std::uint64_t> interval;  ///< coupling interval; any without a value
  FaultPhase phase = FaultPhase::advance;
  std::optional<std::uint64_t> epoch = 0;  ///< how often the run has been resumed; any without a value
  std::uint64_t occurrence = 1;            ///< strikes the n-th time that interval, phase and epoch fit
  FaultAction action = FaultAction::kill;
  double seconds = 0;       ///< wall, of stop_for and sleep [s]
  int code = 0;             ///< of exit
  std::string field;        ///< of nan and negative: name of the array; empty: the first one of numbers
  std::uint64_t index = 0;  ///< of the value in it
};

/// The names of the phases of "structure", "network" or "coupler".
std::vector<std::string> phases_of(std::string_view role);

/// The tables [[fault]] of a fault plan; what is wrong with them goes to the list of `document`.
std::vector<ProcessFault> read_process_faults(input::TableReader& document);

/// The short spelling of one fault: "ROLE@INTERVAL=DO" or "ROLE@INTERVAL:PHASE=DO", e.g. "structure@40=spin".
/// Without a phase it is `answer` for nan and negative, else `advance` or the coupler's `network`; actions
/// that need a number are not spelled so. Throws InputError naming the text and what was expected.
ProcessFault parse_process_fault(const std::string& text);

}  // namespace fissura
