// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/seismic_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "common/case/case_json.hpp"
#include "common/errors.hpp"
#include "coupler/report/drawn_numbers.hpp"
#include "coupler/report/seismic_events.hpp"
#include "coupler/report/thinning.hpp"
#include "coupler/report/whole_lines.hpp"
#include "coupler/seismicity/analysis/analysis_json.hpp"
#include "coupler/seismicity/catalogue/catalogue_csv.hpp"

namespace fissura::coupler {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::size_t most_events = 4000;
constexpr std::size_t parts_of_a_series = 400;

std::vector<double> column_at(const CsvColumns& history, const char* name,
                              const std::vector<std::size_t>& rows) {
  const std::vector<double> values = history.numbers(name);
  std::vector<double> chosen;
  for (const std::size_t row : rows) chosen.push_back(values[row]);
  return chosen;
}

json pumping_json(const CsvColumns& history) {
  const std::vector<std::vector<double>> peaks{history.numbers("rate"), history.numbers("well_pressure")};
  const auto rows = rows_to_draw(history.rows(), peaks, parts_of_a_series);
  return {{"time", column_at(history, "time", rows)},
          {"rate", for_drawing(column_at(history, "rate", rows))},
          {"pressure", for_drawing(column_at(history, "well_pressure", rows))}};
}

SeismicSums sums_in(const json& summary) {
  const json& sums = summary.at("sums");
  SeismicSums read;
  read.raw = sums.at("raw");
  read.aseismic = sums.at("aseismic");
  read.event_moment = sums.at("event_moment");
  read.seismic_sum = sums.at("seismic_sum");
  read.aseismic_sum = sums.at("aseismic_sum");
  return read;
}

/// The catalogue may have been made again with other thresholds than those of the case.
void take_thresholds(const json& summary, Seismicity& thresholds) {
  const json& parameters = summary.at("parameters");
  thresholds.slip_rate = parameters.at("slip_rate");
  thresholds.stress_drop = parameters.at("stress_drop");
  thresholds.failure_rate = parameters.at("failure_rate");
  thresholds.cluster_radius = parameters.at("cluster_radius");
  thresholds.cluster_time = parameters.at("cluster_time");
  thresholds.rest_time = parameters.at("rest_time");
  thresholds.thickness = parameters.at("thickness_equidimensional") == 1 ? SourceThickness::equidimensional
                                                                         : SourceThickness::layer;
}

/// What is still open counts as aseismic in the tensor, and not at all in the sums. Sums are those of the
/// whole layer, whatever thickness the events have.
SeismicSums sums_so_far(const std::vector<SeismicEvent>& events, const CsvColumns& history,
                        double thickness) {
  const auto last = [&](const char* column) {
    const std::vector<double> values = history.numbers(column);
    return values.empty() ? 0.0 : values.back();
  };
  SeismicSums sums;
  sums.raw = {last("source_moment_xx"), last("source_moment_yy"), last("source_moment_zz"),
              last("source_moment_xy")};
  sums.aseismic = sums.raw;
  sums.aseismic_sum = last("aseismic_moment");
  for (const SeismicEvent& event : events) {
    const double to_layer = thickness / event.thickness;
    for (std::size_t i = 0; i < sums.raw.size(); ++i) sums.aseismic[i] -= to_layer * event.moment[i];
    sums.event_moment += event.scalar_moment;
    sums.seismic_sum += to_layer * event.scalar_sum;
  }
  return sums;
}

/// Of the catalogue's own summary, with its thresholds, or of the run so far.
SeismicSums sums_of_catalogue(const fs::path& summary_file, const std::vector<SeismicEvent>& events,
                              const CsvColumns& history, Case& run_case) {
  if (!fs::exists(summary_file)) return sums_so_far(events, history, run_case.domain.thickness);
  try {
    const json summary = json::parse(whole_text(summary_file));
    take_thresholds(summary, run_case.seismicity);
    return sums_in(summary);
  } catch (const json::exception& fault) {
    throw InputError(fmt::format("{} is damaged: {}", summary_file.string(), fault.what()));
  }
}

json distance_json(const std::vector<SeismicEvent>& events, const std::vector<std::size_t>& shown,
                   const Case& run_case) {
  const std::optional<DistanceTime> found = distance_time(events, run_case);
  if (!found) return nullptr;
  json result = json_of(*found);
  std::vector<double> times, distances;
  for (const std::size_t number : shown) {
    times.push_back(events[number].centroid_time);
    distances.push_back(found->distance[number]);
  }
  result["time"] = times;
  result["distance"] = for_drawing(distances);
  return result;
}

/// Evenly over the history, and at the greatest events.
std::vector<double> times_of_budget(const std::vector<SeismicEvent>& events, const CsvColumns& history) {
  std::set<double> times{0};
  for (const double time :
       column_at(history, "time", evenly_spread(history.rows(), std::min(history.rows(), parts_of_a_series))))
    times.insert(time);
  for (const std::size_t number : events_to_draw(events, parts_of_a_series))
    times.insert(std::max(0.0, events[number].centroid_time));
  return {times.begin(), times.end()};
}

json slip_json(const json& joints, double time) {
  if (joints.is_null()) return nullptr;
  const json* nearest = nullptr;
  for (const json& report : joints.at("reports"))
    if (nearest == nullptr ||
        std::abs(report.at("time").get<double>() - time) < std::abs(nearest->at("time").get<double>() - time))
      nearest = &report;
  const json& units = joints.at("units");
  json segments = json::array();
  for (std::size_t i = 0; i < nearest->at("unit").size(); ++i) {
    const std::size_t unit = nearest->at("unit")[i];
    const auto of_unit = [&](const char* name) { return units.at(name)[unit].get<double>(); };
    const double across = std::cos(of_unit("angle")), up = std::sin(of_unit("angle"));
    segments.push_back({for_drawing(of_unit("x") - of_unit("back") * across),
                        for_drawing(of_unit("y") - of_unit("back") * up),
                        for_drawing(of_unit("x") + of_unit("ahead") * across),
                        for_drawing(of_unit("y") + of_unit("ahead") * up), nearest->at("slip")[i]});
  }
  return {{"time", nearest->at("time")}, {"segments", segments}};
}

}  // namespace

InjectedVolume injected_volume(const CsvColumns& history) {
  return {history.numbers("time"), history.numbers("injected")};
}

json seismic_data(const fs::path& run_directory, const json& run_case, const CsvColumns& history,
                  const json& joints) {
  const fs::path folder = run_directory / "seismicity";
  if (!fs::exists(folder / "catalogue.csv")) return nullptr;
  const std::vector<SeismicEvent> events = read_catalogue_csv(folder / "catalogue.csv");
  if (events.empty()) return nullptr;

  Case typed = case_from_json(run_case);
  const SeismicSums sums = sums_of_catalogue(folder / "summary.json", events, history, typed);
  const std::vector<std::size_t> shown = events_to_draw(events, most_events);
  double last = 0;
  for (const SeismicEvent& event : events) last = std::max(last, event.centroid_time);
  const std::vector<double> times = history.numbers("time");
  const double reached = std::max(last, times.empty() ? 0 : times.back());
  const double end = reached > 0 ? reached : typed.time.end;

  json data;
  data["columns"] = event_columns_json(events, shown);
  data["shown"] = {{"events", shown.size()}, {"of", events.size()}};
  data["totals"] = totals_json(events, sums);
  data["frequency_magnitude"] =
      json_of(frequency_magnitude(magnitudes_of(events), numerical_magnitude_floor(typed)));
  data["distance"] = distance_json(events, shown, typed);
  data["pumping"] = pumping_json(history);
  data["moment"] = json_of(moment_budget(events, injected_volume(history), typed.rock.shear_modulus(),
                                         times_of_budget(events, history)));
  data["rate"] = json_of(event_rate(events, end));
  data["volume"] = json_of(stimulated_volume(events, typed.seismicity, typed.domain.thickness));
  data["slip"] = slip_json(joints, last);
  data["caption"] = caption(typed, sums);
  if (shown.size() < events.size())
    data["caption"] = fmt::format("{} Drawn: {} of {} events, the greatest among them.", caption(typed, sums),
                                  shown.size(), events.size());
  return data;
}

}  // namespace fissura::coupler
