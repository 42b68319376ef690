// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "coupler/record/run_record.hpp"

/// A run that does the same whenever it comes to the same interval: reports, sources, insertions, meetings.
namespace fissura::coupler::sample {

RunDescription description();

/// Everything that happens in coupling interval `number`, from 1.
void record_interval(RunRecord& record, std::uint64_t number);

/// Intervals `first` to `last`.
void record_intervals(RunRecord& record, std::uint64_t first, std::uint64_t last);

/// The whole run in one life: `last` intervals, closed and finished.
void record_run(const std::filesystem::path& directory, std::uint64_t last);

/// Every result file by its name, but those that tell of wall time (log.jsonl, remeshing_wall.csv, run.json
/// and the checksums over them), superseded segments and the lock.
std::map<std::string, std::string> comparable_files(const std::filesystem::path& directory);

/// Names of files that are in one only, or differ.
std::vector<std::string> differences(const std::map<std::string, std::string>& one,
                                     const std::map<std::string, std::string>& other);

constexpr int reports_per_segment = 3;

}  // namespace fissura::coupler::sample
