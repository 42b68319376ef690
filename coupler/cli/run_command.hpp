// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/case/read_case.hpp"
#include "coupler/cli/prepared_run.hpp"
#include "coupler/launch/supervisor.hpp"

namespace fissura::coupler {

/// `coupler run`, as typed.
struct RunOptions {
  CaseSource source;
  std::optional<std::filesystem::path> directory;  ///< default: runs/NAME, with -VARIANT for each
  std::optional<std::string> network_command;      ///< default: the network beside this program
  std::optional<std::string> structure_command;
  std::optional<std::string> until;  ///< earlier end of the run, e.g. "2 s"
  std::optional<std::string> fault;  ///< one fault in short, see process_fault.hpp
  std::optional<std::filesystem::path> fault_plan;
  std::optional<std::filesystem::path> keys;  ///< directory, see curve_keys.hpp
  std::vector<std::string> awaited;           ///< roles that somebody else starts
  std::vector<std::string> tape;              ///< roles whose messages are recorded
  int threads = 0;                            ///< of the structure; 0: every core
  bool heal = false;                          ///< go on by itself after a death
  bool debug_attach = false;                  ///< a debugger may hold a process: no deadline ends the run
  bool json = false;                          ///< print summary.json instead of the table
  std::vector<std::string> command_line;
};

/// Names of the probes, in the order of the case.
std::vector<std::string> probe_names(const Case& run_case);

/// Reads case, expectations and references and looks at the run directory; creates nothing. Throws Error.
PreparedRun prepare_run(const RunOptions& options);

/// What `coupler resume` may change.
struct ResumeOptions {
  std::filesystem::path directory;
  int threads = 0;  ///< of the structure; 0: as many as before
  bool json = false;
  bool heal = false;
  std::vector<std::string> tape;     ///< roles whose messages are recorded; none: as before
  std::optional<std::string> network_command;  ///< another flow solver goes on; the same if not given
  std::optional<std::string> fault;  ///< as in RunOptions
  std::optional<std::filesystem::path> fault_plan;
};

/// Goes on with a run that ended before its time. @returns the exit code of the program
int resume_command(const ResumeOptions& options);

/// Prepares and runs. @returns the exit code of the program; every failure has been told.
int run_command(const RunOptions& options);

}  // namespace fissura::coupler
