// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/csv_columns.hpp"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

#include "common/errors.hpp"
#include "coupler/report/whole_lines.hpp"

namespace fissura::coupler {

namespace {

/// Cells may stand in quotes (RFC 4180), but not go over the end of a line.
std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells(1);
  bool in_quotes = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const bool doubled = in_quotes && line.compare(at, 2, "\"\"") == 0;
    if (line[at] == '"' && !doubled) {
      in_quotes = !in_quotes;
    } else if (line[at] == ',' && !in_quotes) {
      cells.emplace_back();
    } else {
      cells.back() += line[at];
      if (doubled) ++at;
    }
  }
  return cells;
}

}  // namespace

CsvColumns::CsvColumns(const std::filesystem::path& file) : file_(file) {
  for (const std::string& line : whole_lines(file)) {
    std::vector<std::string> row = split(line);
    if (names_.empty()) {
      names_ = std::move(row);
      for (const std::string& name : names_)
        if (!cells_.try_emplace(name).second)
          throw InputError(fmt::format("{}:1: the column {} is there twice", file.string(), name));
      continue;
    }
    if (row.size() != names_.size())
      throw InputError(fmt::format("{}:{}: {} cells were expected, found {}", file.string(), rows_ + 2,
                                   names_.size(), row.size()));
    for (std::size_t column = 0; column < row.size(); ++column)
      cells_[names_[column]].push_back(std::move(row[column]));
    ++rows_;
  }
}

std::vector<double> CsvColumns::numbers(const std::string& column) const {
  std::vector<double> values;
  for (const std::string& cell : texts(column)) {
    double value = 0;
    const auto [end, failure] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (failure != std::errc() || end != cell.data() + cell.size())
      throw InputError(fmt::format("{}:{}: a number was expected for {}, found \"{}\"", file_.string(),
                                   values.size() + 2, column, cell));
    values.push_back(value);
  }
  return values;
}

const std::vector<std::string>& CsvColumns::texts(const std::string& column) const {
  const auto found = cells_.find(column);
  if (found == cells_.end()) throw InputError(fmt::format("{} has no column \"{}\"", file_.string(), column));
  return found->second;
}

}  // namespace fissura::coupler
