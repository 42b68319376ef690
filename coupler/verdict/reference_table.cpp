// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/verdict/reference_table.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>
#include <system_error>

#include "common/errors.hpp"

namespace fissura::coupler {

namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> cells(std::string_view line) {
  std::vector<std::string_view> result;
  for (;;) {
    const auto comma = line.find(',');
    result.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return result;
    line.remove_prefix(comma + 1);
  }
}

bool read_number(std::string_view text, double& number) {
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  return failure == std::errc() && end == text.data() + text.size() && std::isfinite(number);
}

}  // namespace

ReferenceTable::ReferenceTable(const std::filesystem::path& file) : file_(file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(fmt::format("cannot read the reference {}", file.string()));
  std::vector<std::string> header;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
    const auto row = cells(line);
    if (header.empty()) {
      header.assign(row.begin(), row.end());
      continue;
    }
    if (row.size() != header.size())
      throw InputError(fmt::format("{}:{}: {} columns were expected, found {}", file.string(), number,
                                   header.size(), row.size()));
    for (std::size_t column = 0; column < row.size(); ++column) {
      double value = 0;
      if (!read_number(row[column], value))
        throw InputError(fmt::format("{}:{}: a number was expected for {}, found \"{}\"", file.string(),
                                     number, header[column], row[column]));
      auto& values = columns_[header[column]];
      if (header[column] == "time" && !values.empty() && value <= values.back())
        throw InputError(fmt::format("{}:{}: the time must rise, found {} after {}", file.string(), number,
                                     value, values.back()));
      values.push_back(value);
    }
  }
  if (!columns_.contains("time"))
    throw InputError(fmt::format("{}: a column \"time\" with at least one line was expected", file.string()));
}

Series ReferenceTable::series(const std::string& name) const {
  const auto found = columns_.find(name);
  if (found == columns_.end()) throw InputError(fmt::format("{} has no column \"{}\"", file_.string(), name));
  return {columns_.at("time"), found->second};
}

}  // namespace fissura::coupler
