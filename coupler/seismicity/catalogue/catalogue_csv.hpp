// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "coupler/record/checked_file.hpp"
#include "coupler/seismicity/catalogue/catalogue_context.hpp"
#include "coupler/seismicity/seismic_event.hpp"

/// catalogue.csv: a header, then one line an event; columns in event_columns.cpp and docs/results.md.
namespace fissura::coupler {

/// Both end with a newline.
std::string csv_header();
std::string csv_line(const SeismicEvent& event, const CatalogueContext& context);

/// The file while a run writes it. Throws StorageError.
class CatalogueCsv {
 public:
  /// Creates or empties `file` and hands the header to the system.
  explicit CatalogueCsv(const std::filesystem::path& file);
  /// Goes on with `file` at `mark`, see CheckedFile.
  CatalogueCsv(const std::filesystem::path& file, const FileMark& mark) : file_(file, mark) {}

  /// Appends the events (buffered).
  void append(const std::vector<SeismicEvent>& events, const CatalogueContext& context);
  void flush() { file_.flush(); }
  void sync() { file_.sync(); }
  [[nodiscard]] const FileMark& mark() const { return file_.mark(); }

 private:
  CheckedFile file_;
};

/// The events of such a file, every bit as written. A last line without its end is left out: the run may
/// still be writing it. Columns may stand in any order; those that are not known are passed over. Throws
/// InputError with file and line if it cannot be read, or a column or a value of an event is missing or
/// damaged.
std::vector<SeismicEvent> read_catalogue_csv(const std::filesystem::path& file);

}  // namespace fissura::coupler
