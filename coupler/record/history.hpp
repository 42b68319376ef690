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
#include "coupler/record/probes.hpp"
#include "coupler/record/table_marks.hpp"

namespace fissura::coupler {

/// The text of columns.json: name, unit and meaning of the columns of history.csv and ledger.csv.
std::string columns_json();

/// The series of all coupling times: in memory for the verdict, and on disk as history.csv, ledger.csv and,
/// with probes, probes.csv. Numbers are printed with the fewest digits that read back to the same double.
class History {
 public:
  /// Of a run without probes.
  History();

  /// The run has probes of these names. @pre neither write_to() nor add() yet
  void observe(const std::vector<std::string>& probes);

  /// Creates history.csv, ledger.csv, columns.json (columns_json) and
  /// probes.csv in `directory`. Until then add() only keeps the series in memory. Throws StorageError.
  void write_to(const std::filesystem::path& directory);

  /// Appends one coupling time; see ProbeSeries::add for `probes`. Throws StorageError and ProtocolError.
  void add(const IntervalRecord& record, const std::vector<ProbeValues>& probes);
  /// The same without a word of the probes.
  void add(const IntervalRecord& record) { add(record, {}); }

  /// Hands all lines to the system. Throws StorageError.
  void flush();

  /// Waits until the disk has all lines and enters the marks of the tables. Throws StorageError.
  void save(TableMarks& marks, ByteWriter& archive);
  /// In place of write_to(): cuts the tables in `directory` off at their marks and takes the series from them
  /// again. @pre check_marks. Throws StorageError and Error(checkpoint_unusable).
  void resume(const std::filesystem::path& directory, const TableMarks& marks, ByteReader& archive);

  /// The values of column `name` at all coupling times, or of a quantity of a probe (ProbeSeries::series);
  /// nothing if there is none.
  [[nodiscard]] std::optional<std::span<const double>> series(std::string_view name) const;

  /// The last record. @pre size() > 0
  [[nodiscard]] const IntervalRecord& last() const;
  [[nodiscard]] std::size_t size() const { return values_.front().size(); }

 private:
  struct Tables {
    CheckedFile history, ledger;
  };
  std::optional<Tables> tables_;
  std::vector<std::vector<double>> values_;  ///< one series per column
  std::optional<ProbeSeries> probes_;
  IntervalRecord last_;
};

}  // namespace fissura::coupler
