// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/case/expected.hpp"
#include "common/case/read_case.hpp"
#include "common/exchange/channel.hpp"
#include "common/exchange/message.hpp"
#include "coupler/faults/fault_plan.hpp"

namespace fissura::coupler {

/// A run that has passed every check and may start.
struct PreparedRun {
  CaseReading reading;
  Expectations expectations;
  std::filesystem::path directory;
  double end = 0;  ///< of the run, at most that of the case [s]
  std::string structure_command, network_command;
  std::uint32_t network_since = 0;  ///< epoch since which network_command is in force
  std::optional<std::filesystem::path> keys;  ///< directory, absolute
  std::vector<std::string> awaited;           ///< roles that somebody else starts
  std::vector<std::string> tape;              ///< roles whose messages are recorded
  Listening listening;                        ///< not in resume.json: keys are read anew
  int threads = 1;
  bool json = false;
  bool debug_attach = false;  ///< a debugger may hold a process: no deadline ends the run
  std::optional<std::filesystem::path> fault_plan_file;  ///< absolute
  FaultPlan fault_plan;
  std::vector<std::string> command_line;
  RunId run_id{};
};

/// 16 random bytes.
RunId random_run_id();
/// As run.json and the protocol write it.
std::string hexadecimal(const RunId& run);

/// Writes RUN/resume.json: everything that another process needs to take the run up again, closed by a hash
/// of itself. It stands from before the first process is started until the directory is used for another run.
/// Throws StorageError.
void write_resume_file(const PreparedRun& run);

/// From epoch `run.network_since` on another flow solver goes on with the run: enters its command, and who is
/// awaited, into resume.json. Throws as read_resume_file and write_resume_file.
void change_network_in_resume_file(const PreparedRun& run);

/// What resume.json in `directory` says; faults to inject, how natural fractures were drawn and cleaned, and
/// warnings, are not in it. References of expectations are the copies in RUN/input. Throws
/// Error(checkpoint_unusable) saying what is wrong with the file, and Error(precondition) if there is none.
PreparedRun read_resume_file(const std::filesystem::path& directory);

}  // namespace fissura::coupler
