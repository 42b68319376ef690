// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fissura::coupler {

/// A table of a run directory: a header and lines of cells. A last line without its end is
/// left out, because the run that writes it may still be at it.
class CsvColumns {
 public:
  /// Throws InputError with file and line if it cannot be read or a line has another number of cells than the
  /// header.
  explicit CsvColumns(const std::filesystem::path& file);

  [[nodiscard]] bool has(const std::string& column) const { return cells_.contains(column); }
  [[nodiscard]] std::size_t rows() const { return rows_; }

  /// Column names in the order of the header.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  /// The values of a column; "nan" and "inf" are numbers. Throws InputError if there is no such column or a
  /// cell is not a number.
  [[nodiscard]] std::vector<double> numbers(const std::string& column) const;

  /// The cells of a column as they stand. Throws InputError if there is no such column.
  [[nodiscard]] const std::vector<std::string>& texts(const std::string& column) const;

 private:
  std::filesystem::path file_;
  std::vector<std::string> names_;
  std::map<std::string, std::vector<std::string>> cells_;
  std::size_t rows_ = 0;
};

}  // namespace fissura::coupler
