// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "coupler/launch/healing.hpp"
#include "coupler/launch/status_page.hpp"

namespace fissura::coupler {

/// How a run ended.
struct RunEnd {
  int exit_code = 0;
  RunFailure failure;                       ///< its exit_code is 0 if the run is complete
  std::string last_line;                    ///< of a run that is not complete
  std::optional<std::uint64_t> checkpoint;  ///< interval it can be resumed from; the beginning without
  std::uint32_t epoch = 0;
  std::vector<Death> deaths;  ///< of this start of the program; the last may be the end of the run
  RunStatus status;
  double wall_seconds = 0;  ///< of this start of the program
};

/// The content of run.report.json: `code`, `name`; of a run that is not complete `participant`, `interval`,
/// `phase`, `cause`, `last_line` and `resume` (`command`, `interval`: null for the beginning; absent where it
/// cannot help); `epoch`, `deaths`, `time` and `end` (simulated, s), `intervals`, `wall_seconds`, `run_id`
/// (null before there is one), `directory`.
nlohmann::ordered_json run_report(const std::filesystem::path& run_directory, const RunEnd& end);

inline constexpr const char* run_report_name = "run.report.json";

}  // namespace fissura::coupler
