// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/stress_crosses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "coupler/report/drawn_numbers.hpp"
#include "coupler/report/principal_stress.hpp"

namespace fissura::coupler {

namespace {

using nlohmann::json;

struct Centroids {
  std::vector<double> x, y;  ///< [m]
};

Centroids centroids_of(const std::vector<double>& position, const std::vector<double>& elements) {
  Centroids centroids;
  for (std::size_t corner = 0; corner + 2 < elements.size(); corner += 3) {
    double x = 0, y = 0;
    for (std::size_t local = 0; local < 3; ++local) {
      const auto node = static_cast<std::size_t>(elements[corner + local]);
      x += position[2 * node] / 3;
      y += position[2 * node + 1] / 3;
    }
    centroids.x.push_back(x);
    centroids.y.push_back(y);
  }
  return centroids;
}

/// The element nearest to the middle of each cell; cells without a centroid give none.
std::vector<std::size_t> one_element_per_cell(const Centroids& centroids, const View& view,
                                              int most_crosses) {
  const double width = view.east - view.west, height = view.north - view.south;
  const double edge = std::sqrt(width * height / most_crosses);
  const auto columns = static_cast<std::size_t>(std::max(1.0, std::floor(width / edge)));
  const auto rows = static_cast<std::size_t>(std::max(1.0, std::floor(height / edge)));
  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    std::size_t element = 0;
  };
  std::vector<Nearest> cells(columns * rows);
  for (std::size_t element = 0; element < centroids.x.size(); ++element) {
    const double across = (centroids.x[element] - view.west) / width * static_cast<double>(columns);
    const double up = (centroids.y[element] - view.south) / height * static_cast<double>(rows);
    if (across < 0 || up < 0 || across >= static_cast<double>(columns) || up >= static_cast<double>(rows))
      continue;
    const double distance = std::hypot(across - std::floor(across) - 0.5, up - std::floor(up) - 0.5);
    Nearest& cell = cells[static_cast<std::size_t>(up) * columns + static_cast<std::size_t>(across)];
    if (distance < cell.distance) cell = {distance, element};
  }
  std::vector<std::size_t> chosen;
  for (const Nearest& cell : cells)
    if (std::isfinite(cell.distance)) chosen.push_back(cell.element);
  return chosen;
}

}  // namespace

json stress_crosses(FieldReports& reports, const FieldReport& report, const std::vector<View>& views,
                    int most_crosses) {
  const Centroids centroids = centroids_of(reports.of_mesh(report.geometry, "position"),
                                           reports.of_mesh(report.geometry, "elements"));
  const std::vector<double> xx = reports.of_report(report, "structure/effective_stress_xx");
  const std::vector<double> yy = reports.of_report(report, "structure/effective_stress_yy");
  const std::vector<double> xy = reports.of_report(report, "structure/effective_stress_xy");
  json list = json::array();
  for (const View& view : views) {
    std::vector<double> x, y, angle, greatest, least;
    for (const std::size_t element : one_element_per_cell(centroids, view, most_crosses)) {
      const PrincipalStress principal = principal_stress(xx[element], yy[element], xy[element]);
      x.push_back(centroids.x[element]);
      y.push_back(centroids.y[element]);
      angle.push_back(principal.angle);
      greatest.push_back(principal.greatest_compression);
      least.push_back(principal.least_compression);
    }
    list.push_back({{"name", view.name},
                    {"box", {view.west, view.east, view.south, view.north}},
                    {"x", for_drawing(x)},
                    {"y", for_drawing(y)},
                    {"angle", for_drawing(angle)},
                    {"greatest", for_drawing(greatest)},
                    {"least", for_drawing(least)}});
  }
  return {{"time", report.time}, {"revision", report.revision}, {"views", list}};
}

}  // namespace fissura::coupler
