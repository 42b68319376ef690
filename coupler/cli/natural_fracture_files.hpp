// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "common/case/case.hpp"
#include "common/natural_fractures/natural_network.hpp"

namespace fissura::coupler {

/// The report in one sentence, e.g. "natural fractures: 0 given, 789 drawn, 745 kept, 28.5 km long; cleaning
/// shortened 68, removed 44".
std::string summary_of(const NaturalFractureReport& report);

/// The report for the eyes of a user: the sentence, what was drawn against what was asked for, and every
/// change that cleaning made.
std::vector<std::string> lines_of(const NaturalFractureReport& report);

/// Content of natural_fractures.json: `given`, `drawn`, `kept`, `length`, `sets` and `cleaning`; SI units.
nlohmann::ordered_json natural_fractures_json(const NaturalFractureReport& report);

/// Content of natural_fractures.csv: the traces of a case as meshed, `name,set,x1,y1,x2,y2,length,azimuth`; m
/// and rad. Numbers are as long as needed to read them back exactly.
std::string natural_fractures_csv(const Case& run_case);

/// Writes both into a run directory if the case has natural fractures of sets, traces or a file. Throws
/// StorageError.
void write_natural_fractures(const std::filesystem::path& directory, const Case& run_case,
                             const NaturalFractureReport& report);

}  // namespace fissura::coupler
