// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <vector>

#include "coupler/seismicity/catalogue/catalogue_context.hpp"
#include "coupler/seismicity/catalogue/catalogue_csv.hpp"

/// The files of one catalogue: catalogue.csv, .h5, .vtp, .xml (QuakeML) and summary.json, in a folder of
/// their own. All but the growing CSV file are replaced as a whole. Equal arguments give equal bytes.
namespace fissura::coupler {

enum class CatalogueFormat { csv, hdf5, points, quakeml };

/// Of "csv", "hdf5", "points" or "quakeml". Throws Error(command_line) for any other word.
CatalogueFormat format_of(const std::string& word);

/// All formats that the context allows: QuakeML needs a georeference.
std::set<CatalogueFormat> possible_formats(const CatalogueContext& context);

/// What is asked of the files.
struct CatalogueChoice {
  std::set<CatalogueFormat> formats;
  /// Smaller events, and those without magnitude, are left out of points and QuakeML. CSV and HDF5 are
  /// complete always: other tools build on them.
  std::optional<double> minimum_magnitude;
};

/// Writes the chosen files and summary.json into `directory`, which is created, and removes those files of an
/// earlier catalogue there that are not chosen. `sums` after Extraction::finish(); `analysis` enters the
/// summary. Throws Error(precondition) if QuakeML is chosen without georeference, before anything is written,
/// and StorageError.
void write_catalogue(const std::filesystem::path& directory, const std::vector<SeismicEvent>& events,
                     const SeismicSums& sums, const CatalogueContext& context,
                     const nlohmann::ordered_json& analysis, const CatalogueChoice& choice);

/// summary.json: schema, controls, parameters, sums, seismic_fraction (null without sources),
/// conservation_error and the analysis.
nlohmann::ordered_json catalogue_summary(const SeismicSums& sums, const CatalogueContext& context,
                                         const nlohmann::ordered_json& analysis);

/// Greatest component of raw - aseismic - events over the greatest of raw, 0 of nothing [-]. Of a finished
/// extraction, where nothing is open.
double conservation_error(const SeismicSums& sums);

/// A catalogue that grows with its run. Call order: constructor, any number of append, flush and save,
/// finish.
class Catalogue {
 public:
  /// Creates `directory`, removes an earlier catalogue there and begins catalogue.csv. Throws StorageError.
  Catalogue(const std::filesystem::path& directory, CatalogueContext context);

  /// Goes on with the catalogue in `directory` as save() left it: catalogue.csv is cut off at `mark` and its
  /// events are read again, every bit as they were; the other files go. @pre check_mark of catalogue.csv.
  /// Throws StorageError, and InputError if the file holds what no event has.
  Catalogue(const std::filesystem::path& directory, CatalogueContext context, const FileMark& mark);

  /// Path of catalogue.csv in the folder of a catalogue.
  static std::filesystem::path growing_file(const std::filesystem::path& directory);

  /// Waits until the disk has all lines. @returns how far catalogue.csv has come. Throws StorageError.
  FileMark save();

  /// Appends events to catalogue.csv (buffered). Throws StorageError.
  void append(const std::vector<SeismicEvent>& events);
  /// Hands the lines so far to the system. Throws StorageError.
  void flush();

  /// Completes catalogue.csv and writes all other possible files. Throws StorageError.
  void finish(const SeismicSums& sums, const nlohmann::ordered_json& analysis);

  [[nodiscard]] const std::vector<SeismicEvent>& events() const { return events_; }
  [[nodiscard]] const CatalogueContext& context() const { return context_; }

 private:
  std::filesystem::path directory_;
  CatalogueContext context_;
  CatalogueCsv csv_;
  std::vector<SeismicEvent> events_;
};

}  // namespace fissura::coupler
