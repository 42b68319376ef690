// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/report_data.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/errors.hpp"
#include "coupler/report/comparison.hpp"
#include "coupler/report/csv_columns.hpp"
#include "coupler/report/fracture_map.hpp"
#include "coupler/report/joint_map.hpp"
#include "coupler/report/principal_stress.hpp"
#include "coupler/report/seismic_data.hpp"
#include "coupler/report/stress_crosses.hpp"
#include "coupler/report/stress_maps.hpp"
#include "coupler/report/thinning.hpp"
#include "coupler/report/whole_lines.hpp"

namespace fissura::coupler {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::size_t parts_of_a_series = 1000;
constexpr std::size_t most_maps = 60;
constexpr int most_crosses = 400;
constexpr MapSize size_of_stress_maps{12, 36000};

json json_file(const fs::path& file) {
  try {
    return json::parse(whole_text(file));
  } catch (const json::exception& fault) {
    throw InputError(fmt::format("{} is damaged: {}", file.string(), fault.what()));
  }
}

json json_file_if_there(const fs::path& file) {
  return fs::exists(file) ? json_file(file) : json();
}

std::vector<std::size_t> rows_of(const CsvColumns& history) {
  std::vector<std::vector<double>> peaks;
  for (const char* column : {"relative_residual", "mismatch", "drift", "inlet_net_pressure", "duration"})
    peaks.push_back(history.numbers(column));
  return rows_to_draw(history.rows(), peaks, parts_of_a_series);
}

/// The given rows of a table, as far as it has them. Cells that are no numbers stay text.
json table(const CsvColumns& csv, const std::vector<std::size_t>& rows,
           const std::vector<std::string>& text_columns) {
  json columns = json::object();
  for (const std::string& name : csv.names()) {
    const bool is_text = std::find(text_columns.begin(), text_columns.end(), name) != text_columns.end();
    json list = json::array();
    if (is_text) {
      for (const std::size_t row : rows)
        if (row < csv.rows()) list.push_back(csv.texts(name)[row]);
    } else {
      const std::vector<double> values = csv.numbers(name);
      for (const std::size_t row : rows)
        if (row < csv.rows()) list.push_back(values[row]);
    }
    columns[name] = std::move(list);
  }
  return {{"rows", csv.rows()}, {"columns", std::move(columns)}};
}

/// With the wall times of the same lines, which are kept in a table of their own.
json remeshing_table(const fs::path& file, const fs::path& wall_times) {
  if (!fs::exists(file)) return nullptr;
  const CsvColumns csv(file);
  json remeshing =
      table(csv, evenly_spread(csv.rows(), csv.rows()), {"fracture", "hash_before", "hash_after"});
  std::vector<double> seconds;
  if (fs::exists(wall_times)) seconds = CsvColumns(wall_times).numbers("wall_seconds");
  seconds.resize(csv.rows(), 0);
  remeshing["columns"]["wall_seconds"] = seconds;
  return remeshing;
}

std::vector<std::string> probe_names(const json& run_case) {
  std::vector<std::string> names;
  for (const json& probe : run_case.value("output", json::object()).value("probes", json::array()))
    names.push_back(probe.at("name"));
  return names;
}

json in_situ_axes(const json& run_case) {
  const json& in_situ = run_case.at("in_situ");
  const json& stress = in_situ.at("stress");
  const double pore =
      run_case.at("rock").value("biot_coefficient", 1.0) * in_situ.value("pore_pressure", 0.0);
  const PrincipalStress principal = principal_stress(stress.at(0), stress.at(1), stress.at(2));
  return {{"greatest", pore - principal.greatest_compression},
          {"least", pore - principal.least_compression},
          {"angle", principal.angle}};
}

/// Near the tip, whole fracture, whole domain, at the last report.
std::vector<View> views_at_the_end(FieldReports& reports, const json& run_case) {
  const double width = run_case.at("domain").at("width"), height = run_case.at("domain").at("height");
  const View domain{"whole domain", -width / 2, width / 2, -height / 2, height / 2};
  if (reports.all().empty()) return {domain};
  return views_of(hydraulic_nodes(reports, reports.all().back().revision), domain);
}

json stress_of_last_report(FieldReports& reports, const std::vector<View>& views) {
  if (reports.all().empty() || !has_stress(reports, reports.all().back())) return nullptr;
  return stress_crosses(reports, reports.all().back(), views, most_crosses);
}

json meetings_table(const fs::path& file) {
  if (!fs::exists(file)) return nullptr;
  const CsvColumns csv(file);
  return table(csv, evenly_spread(csv.rows(), csv.rows()), {"hydraulic", "natural", "criterion"});
}

}  // namespace

json report_data(const fs::path& run_directory) {
  for (const char* file : {"run.json", "effective_case.json", "columns.json", "history.csv", "ledger.csv"})
    if (!fs::exists(run_directory / file))
      throw Error(ExitCode::precondition,
                  fmt::format("{} is not a run directory: it has no {}", run_directory.string(), file));
  const json run_case = json_file(run_directory / "effective_case.json");
  const CsvColumns history(run_directory / "history.csv");
  const std::vector<std::size_t> rows = rows_of(history);
  FieldReports reports(run_directory);

  json data;
  data["run"] = json_file(run_directory / "run.json");
  data["summary"] = json_file_if_there(run_directory / "summary.json");
  data["columns"] = json_file(run_directory / "columns.json");
  data["history"] = table(history, rows, {});
  data["ledger"] = table(CsvColumns(run_directory / "ledger.csv"), rows, {});
  data["remeshing"] = remeshing_table(run_directory / "remeshing.csv", run_directory / "remeshing_wall.csv");
  data["comparison"] = comparison(run_directory, run_case.at("time").at("end"), probe_names(run_case));
  data["classical"] =
      history.rows() == 0 ? json() : classical_curves(run_case, history.numbers("time").back());
  data["map"] = fracture_map(reports, most_maps);
  data["joints"] = joint_map(reports, most_maps);
  data["seismicity"] = seismic_data(run_directory, run_case, history, data["joints"]);
  data["meetings"] = meetings_table(run_directory / "meetings.csv");
  const std::vector<View> views = views_at_the_end(reports, run_case);
  data["stress"] = stress_of_last_report(reports, views);
  // The last two views are the whole fracture and the whole domain; without a fracture there is only the
  // domain.
  data["least_stress"] =
      least_stress_map(reports, views[views.size() > 1 ? views.size() - 2 : 0], size_of_stress_maps);
  data["relative_stress"] =
      relative_stress_map(reports, run_case.at("in_situ"), views.back(), size_of_stress_maps);
  data["in_situ"] = in_situ_axes(run_case);
  data["case"] = run_case;
  return data;
}

}  // namespace fissura::coupler
