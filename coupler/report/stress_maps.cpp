// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/stress_maps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include "coupler/report/drawn_numbers.hpp"
#include "coupler/report/principal_stress.hpp"
#include "coupler/report/raster.hpp"
#include "coupler/report/thinning.hpp"

namespace fissura::coupler {

namespace {

using nlohmann::json;

struct Limits {
  double low = 0, high = 0;
};

struct Picture {
  double time = 0;
  Raster raster;
};

/// What is drawn of the stress xx, yy, xy at x, y.
using Scalar = std::function<double(double x, double y, const std::array<double, 3>& stress)>;

Raster picture_of(FieldReports& reports, const FieldReport& report, const Scalar& scalar, const View& view,
                  std::size_t most_cells) {
  const std::vector<double> position = reports.of_mesh(report.geometry, "position"),
                            elements = reports.of_mesh(report.geometry, "elements");
  std::array<std::vector<double>, 3> stress;
  std::size_t component = 0;
  for (const char* name : {"xx", "yy", "xy"})
    stress[component++] = at_nodes(
        position, elements, reports.of_report(report, std::string("structure/effective_stress_") + name));
  std::vector<double> values;
  for (std::size_t node = 0; 2 * node < position.size(); ++node)
    values.push_back(scalar(position[2 * node], position[2 * node + 1],
                            {stress[0][node], stress[1][node], stress[2][node]}));
  return rasterised(position, elements, values, view, empty_raster(view, most_cells));
}

std::vector<Picture> pictures(FieldReports& reports, const Scalar& scalar, const View& view,
                              const MapSize& size) {
  std::vector<Picture> made;
  for (const std::size_t index : evenly_spread(reports.all().size(), size.most_reports)) {
    const FieldReport& report = reports.all()[index];
    if (has_stress(reports, report))
      made.push_back({report.time, picture_of(reports, report, scalar, view, size.most_cells)});
  }
  return made;
}

std::vector<double> sorted_values(const std::vector<Picture>& shown) {
  std::vector<double> values;
  for (const Picture& picture : shown)
    for (const double value : picture.raster.values)
      if (std::isfinite(value)) values.push_back(value);
  std::sort(values.begin(), values.end());
  return values;
}

double at_share(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

json map_of(const std::vector<Picture>& shown, const View& view, const Limits& limits) {
  json list = json::array();
  for (const Picture& picture : shown)
    list.push_back(
        {{"time", picture.time}, {"values", as_bytes(picture.raster.values, limits.low, limits.high)}});
  return {{"box", {view.west, view.east, view.south, view.north}},
          {"columns", shown.front().raster.columns},
          {"rows", shown.front().raster.rows},
          {"low", for_drawing(limits.low)},
          {"high", for_drawing(limits.high)},
          {"reports", list}};
}

/// The middle of a cell of the raster.
std::array<double, 2> middle_of(const Raster& raster, const View& view, std::size_t cell) {
  const double column = static_cast<double>(cell % raster.columns),
               row = static_cast<double>(cell / raster.columns);
  return {view.west + (column + 0.5) * (view.east - view.west) / static_cast<double>(raster.columns),
          view.south + (row + 0.5) * (view.north - view.south) / static_cast<double>(raster.rows)};
}

/// Of the points whose x and y stand in turn [m].
double half_extent(const std::vector<double>& nodes) {
  std::array<double, 2> low{nodes[0], nodes[1]}, high = low;
  for (std::size_t part = 0; part < nodes.size(); ++part) {
    low[part % 2] = std::min(low[part % 2], nodes[part]);
    high[part % 2] = std::max(high[part % 2], nodes[part]);
  }
  return std::max(high[0] - low[0], high[1] - low[1]) / 2;
}

bool is_far(const std::array<double, 2>& place, const std::vector<double>& nodes, double distance) {
  for (std::size_t node = 0; node < nodes.size(); node += 2)
    if (std::hypot(nodes[node] - place[0], nodes[node + 1] - place[1]) <= distance) return false;
  return true;
}

json change_far_away(const Raster& raster, const View& view, const std::vector<double>& nodes) {
  if (nodes.empty()) return nullptr;
  const double distance = half_extent(nodes);
  std::optional<double> greatest;
  for (std::size_t cell = 0; cell < raster.values.size(); ++cell)
    if (!std::isnan(raster.values[cell]) && is_far(middle_of(raster, view, cell), nodes, distance))
      greatest = std::max(greatest.value_or(0), std::abs(raster.values[cell] - 1));
  if (!greatest) return nullptr;
  return {{"distance", for_drawing(distance)}, {"greatest_change", for_drawing(*greatest)}};
}

constexpr double left_out = 0.002;  // share of the values at an end that the colours do not tell apart

}  // namespace

bool has_stress(FieldReports& reports, const FieldReport& report) {
  for (const char* component : {"xx", "yy", "xy"})
    if (!reports.has(report, std::string("structure/effective_stress_") + component)) return false;
  return true;
}

json least_stress_map(FieldReports& reports, const View& view, const MapSize& size) {
  const Scalar least = [](double, double, const std::array<double, 3>& stress) {
    return principal_stress(stress[0], stress[1], stress[2]).least_compression;
  };
  const std::vector<Picture> shown = pictures(reports, least, view, size);
  const std::vector<double> values = sorted_values(shown);
  if (values.empty()) return nullptr;
  Limits limits{at_share(values, left_out), at_share(values, 1 - left_out)};
  // A stress that is the same everywhere still needs a scale.
  const double least_span = std::max(1.0, 1e-3 * std::abs(limits.low));
  if (limits.high - limits.low < least_span) limits = {limits.low - least_span, limits.low + least_span};
  return map_of(shown, view, limits);
}

json relative_stress_map(FieldReports& reports, const json& in_situ, const View& view, const MapSize& size) {
  const std::vector<double> stress = in_situ.at("stress");
  const auto gradient = in_situ.value("stress_gradient", std::vector<std::vector<double>>(4, {0, 0}));
  const auto at_rest = [&](double x, double y) {
    std::array<double, 3> there{};
    for (std::size_t part = 0; part < 3; ++part)
      there[part] = stress[part] + gradient[part][0] * x + gradient[part][1] * y;
    return principal_stress(there[0], there[1], there[2]).greatest_compression;
  };
  for (const double x : {view.west, view.east})
    for (const double y : {view.south, view.north})
      if (!(at_rest(x, y) < 0)) return nullptr;
  const Scalar relative = [&](double x, double y, const std::array<double, 3>& now) {
    return principal_stress(now[0], now[1], now[2]).greatest_compression / at_rest(x, y);
  };
  const std::vector<Picture> shown = pictures(reports, relative, view, size);
  std::vector<double> values = sorted_values(shown);
  if (values.empty()) return nullptr;
  for (double& value : values) value = std::abs(value - 1);
  std::sort(values.begin(), values.end());
  constexpr double least_reach = 1e-3;
  const double reach = std::max(at_share(values, 1 - left_out), least_reach);
  json map = map_of(shown, view, {1 - reach, 1 + reach});
  map["far"] = change_far_away(shown.back().raster, view,
                               reports.of_network(reports.all().back().revision, "position"));
  return map;
}

}  // namespace fissura::coupler
