// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "common/errors.hpp"

namespace fissura::coupler {

namespace {

struct Triangle {
  std::array<std::size_t, 3> node{};
  std::array<double, 3> x{}, y{};

  Triangle(const std::vector<double>& position, const std::vector<double>& elements, std::size_t element) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      node[corner] = static_cast<std::size_t>(elements[3 * element + corner]);
      x[corner] = position[2 * node[corner]];
      y[corner] = position[2 * node[corner] + 1];
    }
  }
  [[nodiscard]] double twice_area() const {
    return (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  }
  /// Area coordinates of a point.
  [[nodiscard]] std::array<double, 3> shares(double at_x, double at_y) const {
    const double whole = twice_area();
    const double second = ((at_x - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (at_y - y[0])) / whole;
    const double third = ((x[1] - x[0]) * (at_y - y[0]) - (at_x - x[0]) * (y[1] - y[0])) / whole;
    return {1 - second - third, second, third};
  }
};

/// The cells whose middles lie between two coordinates.
struct CellRange {
  std::size_t first = 0, end = 0;
};

CellRange cells_between(double low, double high, double origin, double edge, std::size_t count) {
  const double first = std::ceil((low - origin) / edge - 0.5),
               last = std::floor((high - origin) / edge - 0.5);
  const double most = static_cast<double>(count);
  return {static_cast<std::size_t>(std::clamp(first, 0.0, most)),
          static_cast<std::size_t>(std::clamp(last + 1, 0.0, most))};
}

// A cell on the edge of two elements must not fall between them.
constexpr double rounding = -1e-9;

std::string base64(const std::vector<unsigned char>& bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    unsigned group = 0;
    for (std::size_t i = 0; i < 3; ++i) group = group << 8 | (i < count ? bytes[at + i] : 0u);
    for (std::size_t i = 0; i < 4; ++i) text += i <= count ? letters[group >> (18 - 6 * i) & 63] : '=';
  }
  return text;
}

}  // namespace

Raster empty_raster(const View& view, std::size_t most_cells) {
  const double width = view.east - view.west, height = view.north - view.south;
  const double edge = std::sqrt(width * height / static_cast<double>(most_cells));
  Raster raster;
  raster.columns = static_cast<std::size_t>(std::max(1.0, std::round(width / edge)));
  raster.rows = static_cast<std::size_t>(std::max(1.0, std::round(height / edge)));
  raster.values.assign(raster.columns * raster.rows, std::numeric_limits<double>::quiet_NaN());
  return raster;
}

std::vector<double> at_nodes(const std::vector<double>& position, const std::vector<double>& elements,
                             const std::vector<double>& of_elements) {
  std::vector<double> sum(position.size() / 2), weight(position.size() / 2);
  for (std::size_t element = 0; element < of_elements.size(); ++element) {
    const Triangle triangle(position, elements, element);
    const double area = triangle.twice_area() / 2;
    for (const std::size_t node : triangle.node) {
      sum[node] += area * of_elements[element];
      weight[node] += area;
    }
  }
  for (std::size_t node = 0; node < sum.size(); ++node)
    sum[node] = weight[node] > 0 ? sum[node] / weight[node] : std::numeric_limits<double>::quiet_NaN();
  return sum;
}

Raster rasterised(const std::vector<double>& position, const std::vector<double>& elements,
                  const std::vector<double>& of_nodes, const View& view, Raster raster) {
  const double edge_x = (view.east - view.west) / static_cast<double>(raster.columns);
  const double edge_y = (view.north - view.south) / static_cast<double>(raster.rows);
  for (std::size_t element = 0; 3 * element < elements.size(); ++element) {
    const Triangle triangle(position, elements, element);
    const auto [west, east] = std::minmax_element(triangle.x.begin(), triangle.x.end());
    const auto [south, north] = std::minmax_element(triangle.y.begin(), triangle.y.end());
    const CellRange columns = cells_between(*west, *east, view.west, edge_x, raster.columns);
    const CellRange rows = cells_between(*south, *north, view.south, edge_y, raster.rows);
    for (std::size_t row = rows.first; row < rows.end; ++row)
      for (std::size_t column = columns.first; column < columns.end; ++column) {
        const auto shares = triangle.shares(view.west + (static_cast<double>(column) + 0.5) * edge_x,
                                            view.south + (static_cast<double>(row) + 0.5) * edge_y);
        if (*std::min_element(shares.begin(), shares.end()) < rounding) continue;
        double value = 0;
        for (std::size_t corner = 0; corner < 3; ++corner)
          value += shares[corner] * of_nodes[triangle.node[corner]];
        raster.values[row * raster.columns + column] = value;
      }
  }
  return raster;
}

std::string as_bytes(const std::vector<double>& values, double low, double high) {
  ENSURE(low < high);
  constexpr double most = 254;
  std::vector<unsigned char> bytes;
  for (const double value : values)
    bytes.push_back(std::isnan(value) ? 255
                                      : static_cast<unsigned char>(std::lround(
                                            std::clamp((value - low) / (high - low), 0.0, 1.0) * most)));
  return base64(bytes);
}

}  // namespace fissura::coupler
