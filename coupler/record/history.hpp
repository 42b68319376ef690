// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coupler/record/checked_file.hpp"
#include "coupler/record/interval_record.hpp"

namespace fissura::coupler {

/// The series of all coupling times: in memory for the verdict, and on disk as history.csv and ledger.csv.
/// Numbers are printed with the fewest digits that read back to the same double.
class History {
 public:
  /// Creates history.csv, ledger.csv and columns.json (names, units and meaning of the columns of both) in
  /// `directory`. Until then add() only keeps the series in memory. Throws StorageError.
  void write_to(const std::filesystem::path& directory);

  /// Appends one coupling time. Throws StorageError.
  void add(const IntervalRecord& record);

  /// Hands all lines to the system. Throws StorageError.
  void flush();

  /// The values of column `name` at all coupling times; nothing if there is no such column.
  [[nodiscard]] std::optional<std::span<const double>> series(std::string_view name) const;

  /// The last record. @pre size() > 0
  [[nodiscard]] const IntervalRecord& last() const;
  [[nodiscard]] std::size_t size() const { return values_.front().size(); }

  History();

 private:
  struct Tables {
    CheckedFile history, ledger;
  };
  std::optional<Tables> tables_;
  std::vector<std::vector<double>> values_;  ///< one series per column
  IntervalRecord last_;
};

}  // namespace fissura::coupler
