// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"

#include <cstdio>
#include <cstdlib>

namespace fissura {

const char* name(ExitCode code) {
  switch (code) {
    case ExitCode::done: return "DONE";
    case ExitCode::verdict_failed: return "VERDICT-FAILED";
    case ExitCode::command_line: return "COMMAND-LINE";
    case ExitCode::case_invalid: return "CASE-INVALID";
    case ExitCode::precondition: return "PRECONDITION";
    case ExitCode::role_taken: return "ROLE-TAKEN";
    case ExitCode::mismatch: return "MISMATCH";
    case ExitCode::security: return "SECURITY";
    case ExitCode::participant_died: return "PARTICIPANT-DIED";
    case ExitCode::participant_unresponsive: return "PARTICIPANT-UNRESPONSIVE";
    case ExitCode::protocol_violation: return "PROTOCOL-VIOLATION";
    case ExitCode::invalid_values: return "INVALID-VALUES";
    case ExitCode::numerical_failure: return "NUMERICAL-FAILURE";
    case ExitCode::storage_failure: return "STORAGE-FAILURE";
    case ExitCode::out_of_memory: return "OUT-OF-MEMORY";
    case ExitCode::checkpoint_unusable: return "CHECKPOINT-UNUSABLE";
    case ExitCode::internal: return "INTERNAL";
    case ExitCode::interrupted: return "INTERRUPTED";
    case ExitCode::terminated: return "TERMINATED";
  }
  return "UNKNOWN";
}

void ensure_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "internal error: %s does not hold at %s:%d\n", condition, file, line);
  std::abort();
}

}  // namespace fissura
