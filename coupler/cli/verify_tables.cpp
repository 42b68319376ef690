// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/verify_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <vector>

#include "common/errors.hpp"
#include "coupler/record/checked_file.hpp"
#include "coupler/record/hdf5_file.hpp"
#include "coupler/record/interval_record.hpp"
#include "coupler/seismicity/catalogue/catalogue_csv.hpp"
#include "coupler/tape/tape_reader.hpp"

namespace fissura::coupler {

namespace {

// The sum of six volumes in another order than the flow solver's.
constexpr double rounding = 1e-13;

std::vector<std::string> whole_lines_of(const std::filesystem::path& file) {
  std::istringstream stream(read_whole_file(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line) && !stream.eof();) lines.push_back(line);
  return lines;
}

[[noreturn]] void refuse(std::size_t line, const std::string& what) {
  throw StorageError(fmt::format("line {}: {}", line, what));
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

/// Lines of numbers below a header.
class NumberLines {
 public:
  explicit NumberLines(const std::filesystem::path& file) : lines_(whole_lines_of(file)) {
    if (lines_.empty()) throw StorageError("it has no header");
    names_ = cells_of(lines_.front());
  }
  [[nodiscard]] std::size_t count() const { return lines_.size() - 1; }
  /// Of line `row`, from 0 below the header.
  [[nodiscard]] std::vector<double> values(std::size_t row) const {
    std::vector<double> values;
    for (const std::string& cell : cells_of(lines_[row + 1])) {
      double value = 0;
      const auto [end, failure] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
      if (failure != std::errc() || end != cell.data() + cell.size())
        refuse(row + 2, fmt::format("\"{}\" is no number", cell));
      values.push_back(value);
    }
    if (values.size() != names_.size())
      refuse(row + 2, fmt::format("{} numbers, the header names {}", values.size(), names_.size()));
    return values;
  }
  [[nodiscard]] std::size_t column(std::string_view name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) throw StorageError(fmt::format("it has no column {}", name));
    return static_cast<std::size_t>(found - names_.begin());
  }

 private:
  std::vector<std::string> lines_, names_;
};

/// Calls `check(line, values)` for every line, whose intervals and times must follow each other.
template <typename Check>
void for_each_interval(const NumberLines& table, const Check& check) {
  const std::size_t interval = table.column("interval"), time = table.column("time");
  double last_interval = 0, last_time = -1;
  for (std::size_t row = 0; row < table.count(); ++row) {
    const std::vector<double> values = table.values(row);
    if (row > 0 && values[interval] != last_interval + 1)
      refuse(row + 2, fmt::format("interval {} after interval {}", values[interval], last_interval));
    if (!(values[time] > last_time))
      refuse(row + 2, fmt::format("time {} s after {} s", values[time], last_time));
    last_interval = values[interval];
    last_time = values[time];
    check(row + 2, values);
  }
}

}  // namespace

std::string check_ledger(const std::filesystem::path& file) {
  const NumberLines table(file);
  const std::size_t injected = table.column("injected"), in_place = table.column("in_place"),
                    found = table.column("found"), in_fractures = table.column("in_fractures"),
                    leaked = table.column("leaked"), reset = table.column("reset"),
                    residual = table.column("residual"), relative = table.column("relative_residual");
  double worst = 0;
  for_each_interval(table, [&](std::size_t line, const std::vector<double>& v) {
    double largest = 0;
    for (const std::size_t volume : {injected, in_place, found, in_fractures, leaked, reset})
      largest = std::max(largest, std::abs(v[volume]));
    const double sum = v[injected] + v[in_place] + v[found] + v[reset] - v[in_fractures] - v[leaked];
    if (!(std::abs(sum - v[residual]) <= rounding * largest))
      refuse(line, fmt::format("the volumes leave {} m3, the residual is {} m3", sum, v[residual]));
    if (!(v[relative] <= largest_relative_residual))
      refuse(line, fmt::format("the relative residual is {}, allowed is {}", v[relative],
                               largest_relative_residual));
    worst = std::max(worst, v[relative]);
  });
  return fmt::format("{} lines balance, greatest relative residual {:.1e}", table.count(), worst);
}

std::string check_history(const std::filesystem::path& file) {
  const NumberLines table(file);
  for_each_interval(table, [](std::size_t, const std::vector<double>&) {});
  return fmt::format("{} coupling times follow each other", table.count());
}

std::string check_log(const std::filesystem::path& file) {
  const std::vector<std::string> lines = whole_lines_of(file);
  for (std::size_t number = 0; number < lines.size(); ++number)
    if (!nlohmann::json::accept(lines[number])) refuse(number + 1, "it is no JSON");
  return fmt::format("{} lines of JSON", lines.size());
}

std::string check_catalogue(const std::filesystem::path& file) {
  return fmt::format("{} events", read_catalogue_csv(file).size());
}

std::string check_arrays(const std::filesystem::path& file) {
  const Hdf5File opened = Hdf5File::open(file);
  const std::vector<std::string> names = opened.datasets();
  for (const std::string& name : names) (void)opened.read(name);
  return fmt::format("{} arrays with their checksums", names.size());
}

std::string check_tape(const std::filesystem::path& file) {
  TapeReader tape(file);
  std::uint64_t count = 0;
  for (; const std::optional<TapeRecord> record = tape.next(); ++count)
    if (record->damaged)
      throw StorageError(fmt::format("message {} at byte {}: its checksum differs", count, record->offset));
  const char* end = tape.cut_bytes() > 0 ? ", the last one is cut off" : "";
  return fmt::format("{} messages, each with its checksum{}", count, end);
}

}  // namespace fissura::coupler
