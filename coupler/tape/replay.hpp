// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "common/errors.hpp"
#include "coupler/tape/tape.hpp"

namespace fissura::coupler {

/// Whether a debugger may hold the participant: then no deadline ends a replay.
enum class Patience { of_the_case, endless };

struct ReplayResult {
  ExitCode code = ExitCode::done;    ///< `verdict_failed`: an answer differs
  std::string finding;               ///< why it is another code, or what else is to be told; lines
  std::uint64_t identical = 0;       ///< answers, HELLO among them
  std::uint64_t said = 0;            ///< messages to the participant
  std::uint64_t interval = 0;        ///< the greatest of an identical answer
  std::string taped_solver, solver;  ///< name and version
  /// Wall time from HELLO to the last identical answer, and what of it passed between a command and its
  /// answer: in the live run, and now [s].
  double live_seconds = 0, seconds = 0, live_answering = 0, answering = 0;
};

struct ReplayOptions {
  std::filesystem::path tape;
  std::string command;  ///< shell command of the participant; `--connect ENDPOINT` is appended
  Patience patience = Patience::of_the_case;
  std::optional<std::uint64_t> until = {};  ///< last coupling interval to replay
  /// Called when the participant has introduced itself, with the process that said so.
  std::function<void(long pid)> on_hello = {};
  /// Called with the result, before the participant is ended.
  std::function<void(const ReplayResult&)> on_end = {};
};

/// Runs one participant alone against a tape: says what the coupler said, and compares what is answered with
/// what was answered then (message_difference.hpp). Stops at the first difference. A tape whose last command
/// has no answer (the participant died over it) is replayed to see what becomes of that. With endless
/// patience, a participant that a debugger holds at the end is left to it until it lets go. Throws
/// Error(precondition) without such a tape, StorageError if it is damaged.
ReplayResult replay(const ReplayOptions& options);

}  // namespace fissura::coupler
