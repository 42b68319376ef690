// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/seismicity_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "common/case/case_json.hpp"
#include "common/case/names.hpp"
#include "common/case/units.hpp"
#include "common/errors.hpp"
#include "coupler/report/csv_columns.hpp"
#include "coupler/report/seismic_data.hpp"
#include "coupler/seismicity/analysis/analysis_json.hpp"
#include "coupler/seismicity/catalogue/catalogue.hpp"
#include "coupler/seismicity/catalogue/raw_records.hpp"

namespace fissura::coupler {

namespace {

namespace fs = std::filesystem;

nlohmann::json json_file(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream)
    throw Error(ExitCode::precondition,
                fmt::format("{} cannot be read: is it in a run directory?", file.string()));
  try {
    return nlohmann::json::parse(stream);
  } catch (const nlohmann::json::exception& fault) {
    throw StorageError(fmt::format("{} is damaged: {}", file.string(), fault.what()));
  }
}

void set_if_given(double& threshold, const char* option, const std::optional<std::string>& text,
                  const input::Dimension& dimension) {
  if (!text) return;
  try {
    threshold = input::in_si(*text, dimension);
  } catch (const InputError& fault) {
    throw Error(ExitCode::command_line, fmt::format("{} {}: expected {}", option, *text, fault.what()));
  }
  if (threshold < 0)
    throw Error(ExitCode::command_line, fmt::format("{} {}: expected nothing negative", option, *text));
}

Seismicity changed(Seismicity thresholds, const SeismicityOptions& options) {
  namespace dimension = input::dimension;
  set_if_given(thresholds.cluster_radius, "--cluster-radius", options.cluster_radius, dimension::length);
  set_if_given(thresholds.cluster_time, "--cluster-time", options.cluster_time, dimension::time);
  set_if_given(thresholds.rest_time, "--rest-time", options.rest_time, dimension::time);
  set_if_given(thresholds.slip_rate, "--slip-rate", options.slip_rate, dimension::velocity);
  set_if_given(thresholds.stress_drop, "--stress-drop", options.stress_drop, dimension::stress);
  set_if_given(thresholds.failure_rate, "--failure-rate", options.failure_rate, dimension::velocity);
  for (const Named<SourceThickness>& thickness : source_thicknesses)
    if (options.thickness == thickness.name) thresholds.thickness = thickness.value;
  return thresholds;
}

std::set<CatalogueFormat> formats_of(const SeismicityOptions& options, const CatalogueContext& context) {
  if (options.formats.empty()) return possible_formats(context);
  std::set<CatalogueFormat> formats;
  for (const std::string& word : options.formats) formats.insert(format_of(word));
  return formats;
}

void print_row(const char* name, const std::string& value, const char* remark) {
  fmt::print("{:<28} {:>14} {}\n", name, value, remark);
}

void print_table(const std::vector<SeismicEvent>& events, const SeismicSums& sums,
                 const CatalogueChoice& choice) {
  std::optional<double> greatest;
  std::size_t shown = 0;
  for (const SeismicEvent& event : events) {
    if (!event.magnitude) continue;
    greatest = std::max(greatest.value_or(*event.magnitude), *event.magnitude);
    if (choice.minimum_magnitude && *event.magnitude >= *choice.minimum_magnitude) ++shown;
  }
  double event_moment = 0;
  for (const SeismicEvent& event : events) event_moment += event.scalar_moment;
  const std::optional<double> fraction = seismic_fraction(sums);
  print_row("records", fmt::format("{}", sums.records), "");
  print_row("events", fmt::format("{}", events.size()), "");
  if (choice.minimum_magnitude)
    print_row("of these in points, QuakeML", fmt::format("{}", shown),
              fmt::format("from magnitude {} on", *choice.minimum_magnitude).c_str());
  print_row("greatest magnitude", greatest ? fmt::format("{:.3f}", *greatest) : "-", "Mw");
  print_row("moment of all events", fmt::format("{:.6g}", event_moment), "N m");
  print_row("seismic fraction", fraction ? fmt::format("{:.6f}", *fraction) : "-",
            "of the scalar moments of records");
  print_row("conservation error", fmt::format("{:.2g}", conservation_error(sums)),
            "raw - aseismic - events, relative");
}

void print_b_value(const nlohmann::json& magnitudes) {
  const nlohmann::json& b = magnitudes.at("b");
  if (b.is_null())
    print_row("b", "-", magnitudes.at("not_reported").get<std::string>().c_str());
  else
    print_row(
        "b", fmt::format("{:.3f}", b.at("value").get<double>()),
        fmt::format("+- {:.3f} ({})", b.at("sigma_shi_bolt").get<double>(), b.at("method").get<std::string>())
            .c_str());
}

}  // namespace

int seismicity_command(const SeismicityOptions& options) {
  Case run_case = case_from_json(json_file(options.run_directory / "effective_case.json"));
  const nlohmann::json run = json_file(options.run_directory / "run.json");
  if (!run_case.seismicity.active)
    throw Error(ExitCode::precondition,
                "the case says seismicity.active = false: its run recorded no sources");

  run_case.seismicity = changed(run_case.seismicity, options);
  const CatalogueContext context{run.value("run_id", ""), run.value("title", ""), run.value("started", ""),
                                 extraction_controls(run_case), run_case.georeference};
  const CatalogueChoice choice{formats_of(options, context), options.minimum_magnitude};

  Extraction extraction(context.controls);
  std::vector<SeismicEvent> events;
  const auto take = [&](const std::vector<SeismicEvent>& closed) {
    events.insert(events.end(), closed.begin(), closed.end());
  };
  for_each_source_group(options.run_directory, [&](double time, const std::vector<SourceRecord>& records) {
    take(extraction.advance(time, records));
  });
  take(extraction.finish());

  const fs::path directory = options.directory.value_or(options.run_directory / "seismicity_rebuilt");
  const nlohmann::json analysis =
      analysis_json(events, run_case, injected_volume(CsvColumns(options.run_directory / "history.csv")),
                    extraction.sums());
  write_catalogue(directory, events, extraction.sums(), context, analysis, choice);
  print_table(events, extraction.sums(), choice);
  print_b_value(analysis.at("frequency_magnitude"));
  fmt::print("{}\n", directory.string());
  return static_cast<int>(ExitCode::done);
}

}  // namespace fissura::coupler
