// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "coupler/launch/status_page.hpp"

namespace fissura::coupler {

/// What can be learnt of a run from its directory, whatever became of the run. Waits for nothing.
struct RunState {
  std::filesystem::path directory;
  std::optional<long> supervisor;           ///< the process that holds the run: it is going on
  std::optional<RunStatus> status;          ///< as the worker left it; nothing if there is no page
  nlohmann::json report;                    ///< run.report.json; null if there is none
  std::optional<std::uint64_t> checkpoint;  ///< interval of the newest one
};

/// Throws Error(precondition) if `directory` is not a run directory or may not be read.
RunState read_run_state(const std::filesystem::path& directory);

/// The state as `coupler status --json` prints it. Times in seconds. `state` is "running", "ended", or
/// "killed" if it is not going on and left no report.
nlohmann::ordered_json run_state_json(const RunState& state);

/// The state in a few lines for a reader.
std::string run_state_text(const RunState& state);

}  // namespace fissura::coupler
