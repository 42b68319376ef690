// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/polyline_file.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "common/errors.hpp"

namespace fissura::input {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_points = 10000, most_bytes = 100 * most_points;

std::optional<double> number_at(std::string_view text, std::size_t& place) {
  while (place < text.size() && (text[place] == ' ' || text[place] == '\t')) ++place;
  double value = 0;
  const auto [end, status] = std::from_chars(text.data() + place, text.data() + text.size(), value);
  if (status != std::errc{} || !std::isfinite(value)) return {};
  place = static_cast<std::size_t>(end - text.data());
  while (place < text.size() && (text[place] == ' ' || text[place] == '\t' || text[place] == '\r')) ++place;
  return value;
}

std::optional<Point> point_of(std::string_view line) {
  std::size_t place = 0;
  const auto x = number_at(line, place);
  if (!x || place >= line.size() || line[place++] != ',') return {};
  const auto y = number_at(line, place);
  if (!y || place != line.size()) return {};
  return Point{*x, *y};
}

}  // namespace

fs::path inside(const fs::path& folder, const std::string& name) {
  const InputError outside("a relative path that stays in the case folder");
  std::error_code trouble;
  if (fs::path(name).is_absolute()) throw outside;
  const fs::path root = fs::weakly_canonical(folder, trouble);
  const fs::path file = fs::weakly_canonical(root / name, trouble);
  if (trouble || file.lexically_relative(root).begin()->string() == "..") throw outside;
  if (!fs::is_regular_file(file, trouble))
    throw InputError(fmt::format("a file of the case folder; there is no file {}", file.string()));
  return file;
}

std::vector<Point> read_polyline(const fs::path& file) {
  std::error_code trouble;
  if (fs::file_size(file, trouble) > most_bytes)
    throw InputError(fmt::format("a file of at most {} bytes", most_bytes));
  std::ifstream stream(file);
  if (!stream) throw InputError(fmt::format("a readable file; {} cannot be opened", file.string()));
  std::vector<Point> points;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (line.empty() || line == "\r" || line.front() == '#') continue;
    const auto point = point_of(line);
    if (!point)
      throw InputError(fmt::format("x,y in metres on every line; {}:{} has \"{}\"", file.string(), number,
                                   line.substr(0, 80)));
    points.push_back(*point);
    if (points.size() > most_points)
      throw InputError(fmt::format("at most {} points; {} has more", most_points, file.string()));
  }
  if (points.size() < 2)
    throw InputError(fmt::format("at least two points; {} has {}", file.string(), points.size()));
  return points;
}

}  // namespace fissura::input
