// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/case/case.hpp"
#include "common/seismicity/source_record.hpp"
#include "coupler/record/interval_record.hpp"
#include "coupler/seismicity/catalogue/catalogue.hpp"
#include "coupler/seismicity/extraction.hpp"

namespace fissura::coupler {

/// Of the catalogue, in the directory of a run.
constexpr const char* catalogue_folder = "seismicity";

/// Makes events of what the structure tells, and a catalogue of events, while the run goes on. Call order:
/// constructor; begin or resume; any number of listen, flush and save; finish. Without begin nothing is
/// written.
class SeismicMonitor {
 public:
  explicit SeismicMonitor(const Case& run_case);

  /// Begins the catalogue in `folder`, which is created. `run_id` and `started` are those of run.json.
  /// Nothing if the case wants no seismicity. Throws StorageError.
  void begin(const std::filesystem::path& folder, const std::string& run_id, const std::string& started);

  /// Waits until the disk has the catalogue so far and returns everything that later events depend on, for a
  /// checkpoint: how far the catalogue has come, sources and clusters that are still open, sums. Throws
  /// StorageError.
  [[nodiscard]] std::vector<std::byte> save();

  /// Whether a run can go on in `folder` from `bytes` of save(): throws Error(checkpoint_unusable), naming
  /// the file, if the catalogue is shorter than it was or is another up to there. Changes nothing.
  static void check(const std::filesystem::path& folder, const std::vector<std::byte>& bytes);

  /// How far the catalogue had come at `bytes` of save(); nothing of a run without one. Throws
  /// Error(checkpoint_unusable).
  static std::optional<FileMark> mark(const std::vector<std::byte>& bytes);

  /// In place of begin(): goes on from where save() found it. Throws as check(), before anything is changed,
  /// and StorageError.
  void resume(const std::filesystem::path& folder, const std::string& run_id, const std::string& started,
              const std::vector<std::byte>& bytes);

  /// Takes the sources of the interval that ends at `time` [s]; events that can no longer change enter the
  /// catalogue. Throws StorageError.
  void listen(double time, const std::vector<SourceRecord>& sources);

  /// Hands the catalogue so far to the system. Throws StorageError.
  void flush();

  /// Closes the events that are still open.
  void conclude();

  /// Writes all files of the catalogue, with this analysis of the events. @pre concluded. Throws
  /// StorageError.
  void finish(const nlohmann::ordered_json& analysis);

  /// That are in the catalogue.
  [[nodiscard]] const std::vector<SeismicEvent>& events() const;
  [[nodiscard]] const SeismicSums& sums() const { return extraction_.sums(); }
  [[nodiscard]] SeismicFigures figures() const;
  /// `events`, `seismic_moment`, `aseismic_moment` [N m], `greatest_magnitude` and `seismic_fraction` (null
  /// without any), `conservation_error`; null without a catalogue. @pre concluded
  [[nodiscard]] nlohmann::ordered_json summary() const;
  /// Wall time spent here [s].
  [[nodiscard]] double wall_seconds() const { return wall_seconds_; }

 private:
  [[nodiscard]] CatalogueContext context(const std::string& run_id, const std::string& started) const;

  const Case& case_;
  Extraction extraction_;
  std::optional<Catalogue> catalogue_;
  double wall_seconds_ = 0;
};

}  // namespace fissura::coupler
