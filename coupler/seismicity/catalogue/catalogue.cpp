// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/catalogue/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "common/errors.hpp"
#include "coupler/record/checked_file.hpp"
#include "coupler/seismicity/catalogue/catalogue_hdf5.hpp"
#include "coupler/seismicity/catalogue/catalogue_points.hpp"
#include "coupler/seismicity/catalogue/controls_text.hpp"
#include "coupler/seismicity/catalogue/quakeml.hpp"

namespace fissura::coupler {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* summary_name = "summary.json";

const char* file_of(CatalogueFormat format) {
  switch (format) {
    case CatalogueFormat::csv:
      return "catalogue.csv";
    case CatalogueFormat::hdf5:
      return "catalogue.h5";
    case CatalogueFormat::points:
      return "catalogue.vtp";
    case CatalogueFormat::quakeml:
      return "catalogue.xml";
  }
  return "";
}

constexpr std::array all_formats{CatalogueFormat::csv, CatalogueFormat::hdf5, CatalogueFormat::points,
                                 CatalogueFormat::quakeml};

/// Leaves nothing of an earlier catalogue but `kept`, which would not go with what is written now.
void make_room(const fs::path& directory, const std::set<CatalogueFormat>& kept) {
  std::error_code failure;
  fs::create_directories(directory, failure);
  for (const CatalogueFormat format : all_formats)
    if (!failure && !kept.contains(format)) fs::remove(directory / file_of(format), failure);
  if (!failure) fs::remove(directory / summary_name, failure);
  if (failure)
    throw StorageError(
        fmt::format("cannot make room for a catalogue in {}: {}", directory.string(), failure.message()));
}

const fs::path& with_room(const fs::path& directory, const std::set<CatalogueFormat>& kept) {
  make_room(directory, kept);
  return directory;
}

std::vector<SeismicEvent> not_smaller(const std::vector<SeismicEvent>& events,
                                      const std::optional<double>& magnitude) {
  if (!magnitude) return events;
  std::vector<SeismicEvent> greater;
  std::copy_if(events.begin(), events.end(), std::back_inserter(greater),
               [&](const SeismicEvent& event) { return event.magnitude && *event.magnitude >= *magnitude; });
  return greater;
}

std::string whole_csv(const std::vector<SeismicEvent>& events, const CatalogueContext& context) {
  std::string text = csv_header();
  for (const SeismicEvent& event : events) text += csv_line(event, context);
  return text;
}

/// Everything but the CSV file.
void write_others(const fs::path& directory, const std::vector<SeismicEvent>& events, const SeismicSums& sums,
                  const CatalogueContext& context, const ordered_json& analysis,
                  const CatalogueChoice& choice) {
  const auto is_chosen = [&](CatalogueFormat format) { return choice.formats.contains(format); };
  const std::vector<SeismicEvent> shown = not_smaller(events, choice.minimum_magnitude);
  if (is_chosen(CatalogueFormat::hdf5))
    write_catalogue_hdf5(directory / file_of(CatalogueFormat::hdf5), events, sums, context);
  if (is_chosen(CatalogueFormat::points))
    write_whole_file(directory / file_of(CatalogueFormat::points), catalogue_points(shown, context));
  if (is_chosen(CatalogueFormat::quakeml))
    write_whole_file(directory / file_of(CatalogueFormat::quakeml), quakeml(shown, context));
  write_whole_file(directory / summary_name, catalogue_summary(sums, context, analysis).dump(2) + "\n");
}

}  // namespace

CatalogueFormat format_of(const std::string& word) {
  if (word == "csv") return CatalogueFormat::csv;
  if (word == "hdf5") return CatalogueFormat::hdf5;
  if (word == "points") return CatalogueFormat::points;
  if (word == "quakeml") return CatalogueFormat::quakeml;
  throw Error(ExitCode::command_line,
              fmt::format("\"{}\" is no format of a catalogue: expected csv, hdf5, points or quakeml", word));
}

std::set<CatalogueFormat> possible_formats(const CatalogueContext& context) {
  std::set<CatalogueFormat> formats(all_formats.begin(), all_formats.end());
  if (!context.georeference) formats.erase(CatalogueFormat::quakeml);
  return formats;
}

void write_catalogue(const fs::path& directory, const std::vector<SeismicEvent>& events,
                     const SeismicSums& sums, const CatalogueContext& context, const ordered_json& analysis,
                     const CatalogueChoice& choice) {
  if (choice.formats.contains(CatalogueFormat::quakeml)) (void)quakeml({}, context);
  make_room(directory, {});
  if (choice.formats.contains(CatalogueFormat::csv))
    write_whole_file(directory / file_of(CatalogueFormat::csv), whole_csv(events, context));
  write_others(directory, events, sums, context, analysis, choice);
}

ordered_json catalogue_summary(const SeismicSums& sums, const CatalogueContext& context,
                               const ordered_json& analysis) {
  ordered_json summary;
  summary["schema"] = 1;
  summary["run_id"] = context.run_id;
  summary["controls"] = controls_id(context.controls);
  for (const Control& control : controls_of(context.controls))
    summary["parameters"][std::string(control.name)] = control.value;
  summary["sums"] = {{"records", sums.records},
                     {"events", sums.event_count},
                     {"raw", sums.raw},
                     {"aseismic", sums.aseismic},
                     {"in_events", sums.events},
                     {"event_moment", sums.event_moment},
                     {"seismic_sum", sums.seismic_sum},
                     {"aseismic_sum", sums.aseismic_sum},
                     {"greatest_moment", sums.greatest_moment}};
  const std::optional<double> fraction = seismic_fraction(sums);
  summary["seismic_fraction"] = fraction ? ordered_json(*fraction) : ordered_json();
  summary["conservation_error"] = conservation_error(sums);
  summary["analysis"] = analysis;
  return summary;
}

double conservation_error(const SeismicSums& sums) {
  double greatest = 0, error = 0;
  for (std::size_t i = 0; i < sums.raw.size(); ++i) {
    greatest = std::max(greatest, std::abs(sums.raw[i]));
    error = std::max(error, std::abs(sums.raw[i] - sums.aseismic[i] - sums.events[i]));
  }
  return greatest > 0 ? error / greatest : error;
}

Catalogue::Catalogue(const fs::path& directory, CatalogueContext context)
    : directory_(directory),
      context_(std::move(context)),
      csv_(with_room(directory, {}) / file_of(CatalogueFormat::csv)) {}

Catalogue::Catalogue(const fs::path& directory, CatalogueContext context, const FileMark& mark)
    : directory_(directory),
      context_(std::move(context)),
      csv_(growing_file(with_room(directory, {CatalogueFormat::csv})), mark),
      events_(read_catalogue_csv(growing_file(directory))) {}

fs::path Catalogue::growing_file(const fs::path& directory) {
  return directory / file_of(CatalogueFormat::csv);
}

FileMark Catalogue::save() {
  csv_.sync();
  sync_to_disk(directory_);
  return csv_.mark();
}

void Catalogue::append(const std::vector<SeismicEvent>& events) {
  csv_.append(events, context_);
  events_.insert(events_.end(), events.begin(), events.end());
}

void Catalogue::flush() {
  csv_.flush();
}

void Catalogue::finish(const SeismicSums& sums, const ordered_json& analysis) {
  csv_.sync();
  write_others(directory_, events_, sums, context_, analysis, {possible_formats(context_), std::nullopt});
}

}  // namespace fissura::coupler
