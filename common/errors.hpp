// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace fissura {

/// Exit codes of every program of the project. Scripts rely on the numbers; they are never reused.
enum class ExitCode : int {
  done = 0,
  verdict_failed = 1,             ///< the run ended, but a quantity of expected.toml was missed
  command_line = 2,
  case_invalid = 10,
  precondition = 11,              ///< file, permission or machine
  role_taken = 12,                ///< endpoint, run directory or role already in use
  mismatch = 13,                  ///< version, role or topology refused at the handshake
  security = 14,
  participant_died = 20,
  participant_unresponsive = 21,
  protocol_violation = 22,
  invalid_values = 23,            ///< NaN, negative aperture, pressure out of range ... in an exchange
  numerical_failure = 24,         ///< no convergence, unstable step, ledger broken
  storage_failure = 25,
  out_of_memory = 26,
  checkpoint_unusable = 27,
  internal = 70,
  interrupted = 130,
  terminated = 143
};

/// Name of an exit code as printed in the last line of a failed run, e.g. "PARTICIPANT-DIED".
const char* name(ExitCode code);

/// A failure that ends the program with a known exit code. what() is one sentence for the user.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}
  [[nodiscard]] ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// The case or the command line is wrong: the user can mend it.
struct InputError : Error {
  explicit InputError(const std::string& sentence) : Error(ExitCode::case_invalid, sentence) {}
};

/// A peer broke docs/protocol.md.
struct ProtocolError : Error {
  explicit ProtocolError(const std::string& sentence) : Error(ExitCode::protocol_violation, sentence) {}
};

/// A peer sent values that no physics allows (NaN, negative aperture, wrong range).
struct ValueError : Error {
  explicit ValueError(const std::string& sentence) : Error(ExitCode::invalid_values, sentence) {}
};

/// A deadline passed without an answer, or the connection fell silent.
struct UnresponsiveError : Error {
  explicit UnresponsiveError(const std::string& sentence)
      : Error(ExitCode::participant_unresponsive, sentence) {}
};

/// The numbers went wrong: no convergence, unstable step, fluid not conserved.
struct SolverError : Error {
  explicit SolverError(const std::string& sentence) : Error(ExitCode::numerical_failure, sentence) {}
};

/// A file could not be written or read.
struct StorageError : Error {
  explicit StorageError(const std::string& sentence) : Error(ExitCode::storage_failure, sentence) {}
};

/// Prints the failed condition and aborts. Called by ENSURE only.
[[noreturn]] void ensure_failed(const char* condition, const char* file, int line);

}  // namespace fissura

/// A condition that only a defect of ours can break. Always armed; keep it out of inner loops.
#define ENSURE(condition) ((condition) ? (void)0 : ::fissura::ensure_failed(#condition, __FILE__, __LINE__))
