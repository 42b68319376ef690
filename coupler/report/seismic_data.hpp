// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "coupler/report/csv_columns.hpp"
#include "coupler/seismicity/analysis/moment_budget.hpp"

namespace fissura::coupler {

/// Columns `time` and `injected` of history.csv. Throws InputError if they are missing.
InjectedVolume injected_volume(const CsvColumns& history);

/// The catalogue of a run as pictures of it need it (docs/microseismicity.md), in SI, times of the run:
///   columns              seismic_events.hpp; large catalogues are thinned
///   shown                {"events": in columns, "of": in the catalogue}
///   totals               totals_json of analysis_json.hpp
///   frequency_magnitude  json_of there
///   distance             json_of there, and "time" (centroid), "distance" of each event in columns; null in
///   a
///                        dry case
///   pumping              time, rate, pressure of history.csv, thinned
///   moment, rate, volume json_of there
///   slip                 {"time", "segments": [[x0, y0, x1, y1, slip], ...]}: contact units of natural
///                        fractures that have slipped, at the report of `joints` nearest to the last event;
///                        or null
///   caption              how the events were made, for every picture
/// Null without seismicity/catalogue.csv or an event in it. Sums and thresholds are those of
/// seismicity/summary.json or, while the run goes on, of the last line of `history` and the case. `joints`:
/// joint_map.hpp, may be null. Throws InputError if a file is damaged.
nlohmann::json seismic_data(const std::filesystem::path& run_directory, const nlohmann::json& run_case,
                            const CsvColumns& history, const nlohmann::json& joints);

}  // namespace fissura::coupler
