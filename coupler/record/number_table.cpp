// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/number_table.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string>
#include <system_error>

#include "common/errors.hpp"
#include "coupler/record/checked_file.hpp"

namespace fissura::coupler {

std::vector<std::vector<double>> read_number_table(const std::filesystem::path& file, std::size_t columns) {
  const std::string text = read_whole_file(file);
  std::size_t line = 1;
  const auto refuse = [&] {
    throw Error(ExitCode::checkpoint_unusable,
                fmt::format("{}, line {} is not {} numbers", file.string(), line, columns));
  };
  std::vector<std::vector<double>> values(columns);
  const char *place = text.data(), *const end = place + text.size();
  while (place != end && *place++ != '\n') {
  }
  while (place != end) {
    ++line;
    for (std::size_t column = 0; column < columns; ++column) {
      double value = 0;
      const auto [after, failure] = std::from_chars(place, end, value);
      const char separator = column + 1 < columns ? ',' : '\n';
      if (failure != std::errc() || after == end || *after != separator) refuse();
      values[column].push_back(value);
      place = after + 1;
    }
  }
  return values;
}

}  // namespace fissura::coupler
