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

/// As many numbers as `count`, with commas between them and nothing else.
std::optional<std::vector<double>> numbers_of(std::string_view line, std::size_t count) {
  std::vector<double> numbers;
  std::size_t place = 0;
  while (numbers.size() < count) {
    if (!numbers.empty() && (place >= line.size() || line[place++] != ',')) return {};
    const auto number = number_at(line, place);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return place == line.size() ? std::optional(numbers) : std::nullopt;
}

/// The numbers of every line that is not empty and no comment. `form` says what a line should hold, and
/// `unit` what it is.
std::vector<std::vector<double>> read_lines(const fs::path& file, std::size_t count, const char* form,
                                            const char* unit) {
  std::error_code trouble;
  if (fs::file_size(file, trouble) > most_bytes)
    throw InputError(fmt::format("a file of at most {} bytes", most_bytes));
  std::ifstream stream(file);
  if (!stream) throw InputError(fmt::format("a readable file; {} cannot be opened", file.string()));
  std::vector<std::vector<double>> lines;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (line.empty() || line == "\r" || line.front() == '#') continue;
    auto numbers = numbers_of(line, count);
    if (!numbers)
      throw InputError(fmt::format("{} in metres on every line; {}:{} has \"{}\"", form, file.string(),
                                   number, line.substr(0, 80)));
    lines.push_back(std::move(*numbers));
    if (lines.size() > most_points)
      throw InputError(fmt::format("at most {} {}; {} has more", most_points, unit, file.string()));
  }
  return lines;
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
  std::vector<Point> points;
  for (const std::vector<double>& line : read_lines(file, 2, "x,y", "points"))
    points.push_back({line[0], line[1]});
  if (points.size() < 2)
    throw InputError(fmt::format("at least two points; {} has {}", file.string(), points.size()));
  return points;
}

std::vector<std::array<Point, 2>> read_trace_ends(const fs::path& file) {
  std::vector<std::array<Point, 2>> traces;
  for (const std::vector<double>& line : read_lines(file, 4, "x1,y1,x2,y2", "traces"))
    traces.push_back({Point{line[0], line[1]}, Point{line[2], line[3]}});
  if (traces.empty()) throw InputError(fmt::format("at least one trace; {} has none", file.string()));
  return traces;
}

}  // namespace fissura::input
