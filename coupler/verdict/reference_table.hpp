// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "coupler/verdict/series.hpp"

namespace fissura::coupler {

/// A reference solution against time: a CSV file with a header, a column `time` [s] that rises, and columns
/// of quantities in SI. Empty lines and lines that begin with # are skipped.
class ReferenceTable {
 public:
  /// Throws InputError with file and line if it cannot be read or is not of this form.
  explicit ReferenceTable(const std::filesystem::path& file);

  /// Column `name` against time; valid as long as the table. Throws InputError if there is no such column.
  [[nodiscard]] Series series(const std::string& name) const;

 private:
  std::filesystem::path file_;
  std::map<std::string, std::vector<double>> columns_;
};

}  // namespace fissura::coupler
