// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/natural_fracture_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>

#include "coupler/record/checked_file.hpp"
#include "coupler/record/csv_cell.hpp"

namespace fissura::coupler {

namespace {

constexpr double in_degrees = 180 / std::numbers::pi;

struct ActionTotal {
  std::size_t changes = 0;
  double amount = 0;
};

std::map<CleaningAction, ActionTotal> totals(const NaturalFractureReport& report) {
  std::map<CleaningAction, ActionTotal> result;
  for (const CleaningRecord& record : report.cleaning) {
    ++result[record.action].changes;
    result[record.action].amount += record.amount;
  }
  return result;
}

std::string line_of(const char* what, const QuantityStatistics& quantity, double scale, const char* unit) {
  return fmt::format("  {:<12} {:>9.4g} +- {:<8.3g} {:<3} asked for {:>7.4g} +- {:<7.3g} ({} of them)", what,
                     scale * quantity.obtained.mean, scale * quantity.obtained.deviation, unit,
                     scale * quantity.expected.mean, scale * quantity.expected.deviation, quantity.count);
}

nlohmann::ordered_json json_of(const QuantityStatistics& quantity) {
  return {{"count", quantity.count},
          {"mean", quantity.obtained.mean},
          {"deviation", quantity.obtained.deviation},
          {"expected_mean", quantity.expected.mean},
          {"expected_deviation", quantity.expected.deviation}};
}

nlohmann::ordered_json json_of(const SetStatistics& set) {
  return {{"set", set.set},
          {"traces", set.traces},
          {"cleaned_traces", set.cleaned_traces},
          {"orientation", json_of(set.orientation)},
          {"spacing", json_of(set.spacing)},
          {"length", json_of(set.length)},
          {"persistence", json_of(set.persistence)},
          {"density", set.density},
          {"expected_density", set.expected_density},
          {"intensity", set.intensity},
          {"expected_intensity", set.expected_intensity},
          {"cleaned_intensity", set.cleaned_intensity}};
}

}  // namespace

std::string summary_of(const NaturalFractureReport& report) {
  std::string text = fmt::format("natural fractures: {} given, {} drawn, {} kept, {:.4g} m long",
                                 report.given, report.drawn, report.kept, report.length);
  const char* lead = "; cleaning ";
  for (const auto& [action, total] : totals(report)) {
    text += fmt::format("{}{} {} (by {:.3g} m)", lead, name(action), total.changes, total.amount);
    lead = ", ";
  }
  return text;
}

std::vector<std::string> lines_of(const NaturalFractureReport& report) {
  std::vector<std::string> lines{summary_of(report)};
  for (const SetStatistics& set : report.sets) {
    lines.push_back(
        fmt::format("set {}: {} traces drawn, {} after cleaning", set.set, set.traces, set.cleaned_traces));
    lines.push_back(line_of("orientation", set.orientation, in_degrees, "deg"));
    lines.push_back(line_of("spacing", set.spacing, 1, "m"));
    lines.push_back(line_of("length", set.length, 1, "m"));
    lines.push_back(line_of("persistence", set.persistence, 1, "m"));
    lines.push_back(fmt::format("  {:<12} {:>9.4g} 1/m2          expected  {:>7.4g}", "density", set.density,
                                set.expected_density));
    lines.push_back(fmt::format("  {:<12} {:>9.4g} 1/m           expected  {:>7.4g}, after cleaning {:.4g}",
                                "intensity", set.intensity, set.expected_intensity, set.cleaned_intensity));
  }
  for (const CleaningRecord& record : report.cleaning)
    lines.push_back(fmt::format("  '{}' {} by {:.4g} m at ({:.6g}, {:.6g}) m: {}", record.trace,
                                name(record.action), record.amount, record.at[0], record.at[1],
                                record.cause));
  return lines;
}

nlohmann::ordered_json natural_fractures_json(const NaturalFractureReport& report) {
  nlohmann::ordered_json json{
      {"given", report.given}, {"drawn", report.drawn}, {"kept", report.kept}, {"length", report.length}};
  json["sets"] = nlohmann::ordered_json::array();
  for (const SetStatistics& set : report.sets) json["sets"].push_back(json_of(set));
  json["cleaning"] = nlohmann::ordered_json::array();
  for (const CleaningRecord& record : report.cleaning)
    json["cleaning"].push_back({{"set", record.set},
                                {"trace", record.trace},
                                {"action", name(record.action)},
                                {"x", record.at[0]},
                                {"y", record.at[1]},
                                {"amount", record.amount},
                                {"cause", record.cause}});
  return json;
}

std::string natural_fractures_csv(const Case& run_case) {
  std::string text = "name,set,x1,y1,x2,y2,length,azimuth\n";
  for (const FractureLine& line : run_case.fractures) {
    if (line.kind != FractureKind::natural || line.points.size() != 2) continue;
    const auto [x1, y1] = line.points[0];
    const auto [x2, y2] = line.points[1];
    text += fmt::format("{},{},{},{},{},{},{:.6g},{:.6g}\n", csv_cell(line.name), csv_cell(line.set), x1, y1,
                        x2, y2, std::hypot(x2 - x1, y2 - y1), std::atan2(x2 - x1, y2 - y1));
  }
  return text;
}

void write_natural_fractures(const std::filesystem::path& directory, const Case& run_case,
                             const NaturalFractureReport& report) {
  if (report.given + report.drawn == 0) return;
  write_whole_file(directory / "natural_fractures.csv", natural_fractures_csv(run_case));
  write_whole_file(directory / "natural_fractures.json", natural_fractures_json(report).dump(2) + "\n");
}

}  // namespace fissura::coupler
