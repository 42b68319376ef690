// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/seismic_monitor.hpp"

#include <chrono>
#include <cstdint>

#include "common/byte_archive.hpp"
#include "common/errors.hpp"

namespace fissura::coupler {

namespace {

using Clock = std::chrono::steady_clock;

const std::string format_of_state = "seismicity 1";

/// Adds the time until it goes out of scope.
class Watch {
 public:
  explicit Watch(double& seconds) : seconds_(seconds) {}
  ~Watch() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

 private:
  double& seconds_;
  Clock::time_point start_ = Clock::now();
};

struct SavedMonitor {
  std::optional<FileMark> catalogue;
  double wall_seconds = 0;
  std::vector<std::byte> extraction;
};

std::vector<std::byte> bytes_of(const SavedMonitor& saved) {
  ByteWriter archive;
  archive.put(format_of_state);
  archive.put(static_cast<std::uint8_t>(saved.catalogue.has_value()));
  archive.put(saved.catalogue.value_or(FileMark()).bytes);
  archive.put(saved.catalogue.value_or(FileMark()).crc32);
  archive.put(saved.wall_seconds);
  archive.put(saved.extraction);
  return archive.take();
}

SavedMonitor saved_monitor(const std::vector<std::byte>& bytes) {
  ByteReader archive(bytes);
  std::string format;
  archive.get(format);
  if (format != format_of_state)
    throw Error(ExitCode::checkpoint_unusable,
                "the state of the seismic monitor is of another version of the program");
  SavedMonitor saved;
  std::uint8_t has_catalogue = 0;
  FileMark mark;
  archive.get(has_catalogue);
  archive.get(mark.bytes);
  archive.get(mark.crc32);
  archive.get(saved.wall_seconds);
  archive.get(saved.extraction);
  archive.end();
  if (has_catalogue != 0) saved.catalogue = mark;
  return saved;
}

}  // namespace

SeismicMonitor::SeismicMonitor(const Case& run_case)
    : case_(run_case), extraction_(extraction_controls(run_case)) {}

void SeismicMonitor::begin(const std::filesystem::path& folder, const std::string& run_id,
                           const std::string& started) {
  if (case_.seismicity.active) catalogue_.emplace(folder, context(run_id, started));
}

CatalogueContext SeismicMonitor::context(const std::string& run_id, const std::string& started) const {
  return {run_id, case_.title, started, extraction_controls(case_), case_.georeference};
}

std::vector<std::byte> SeismicMonitor::save() {
  SavedMonitor saved;
  if (catalogue_) saved.catalogue = catalogue_->save();
  saved.wall_seconds = wall_seconds_;
  saved.extraction = extraction_.save();
  return bytes_of(saved);
}

std::optional<FileMark> SeismicMonitor::mark(const std::vector<std::byte>& bytes) {
  return saved_monitor(bytes).catalogue;
}

void SeismicMonitor::check(const std::filesystem::path& folder, const std::vector<std::byte>& bytes) {
  if (const auto catalogue = mark(bytes)) check_mark(Catalogue::growing_file(folder), *catalogue);
}

void SeismicMonitor::resume(const std::filesystem::path& folder, const std::string& run_id,
                            const std::string& started, const std::vector<std::byte>& bytes) {
  check(folder, bytes);
  const SavedMonitor saved = saved_monitor(bytes);
  if (saved.catalogue.has_value() != case_.seismicity.active)
    throw Error(ExitCode::checkpoint_unusable, "the saved catalogue is of a run with another [seismicity]");
  extraction_.restore(saved.extraction);
  wall_seconds_ = saved.wall_seconds;
  if (saved.catalogue) catalogue_.emplace(folder, context(run_id, started), *saved.catalogue);
}

void SeismicMonitor::listen(double time, const std::vector<SourceRecord>& sources) {
  const Watch watch(wall_seconds_);
  const std::vector<SeismicEvent> closed = extraction_.advance(time, sources);
  if (catalogue_) catalogue_->append(closed);
}

void SeismicMonitor::flush() {
  if (catalogue_) catalogue_->flush();
}

void SeismicMonitor::conclude() {
  const Watch watch(wall_seconds_);
  const std::vector<SeismicEvent> open = extraction_.finish();
  if (catalogue_) catalogue_->append(open);
}

void SeismicMonitor::finish(const nlohmann::ordered_json& analysis) {
  const Watch watch(wall_seconds_);
  if (catalogue_) catalogue_->finish(extraction_.sums(), analysis);
}

const std::vector<SeismicEvent>& SeismicMonitor::events() const {
  static const std::vector<SeismicEvent> none;
  return catalogue_ ? catalogue_->events() : none;
}

nlohmann::ordered_json SeismicMonitor::summary() const {
  if (!catalogue_) return nullptr;
  const SeismicSums& sums = extraction_.sums();
  const std::optional<double> fraction = seismic_fraction(sums);
  nlohmann::ordered_json summary;
  summary["events"] = sums.event_count;
  summary["seismic_moment"] = sums.event_moment;
  summary["aseismic_moment"] = sums.aseismic_sum;
  summary["greatest_magnitude"] = nullptr;
  if (sums.greatest_moment > 0) summary["greatest_magnitude"] = moment_magnitude(sums.greatest_moment);
  summary["seismic_fraction"] = nullptr;
  if (fraction) summary["seismic_fraction"] = *fraction;
  summary["conservation_error"] = conservation_error(sums);
  return summary;
}

SeismicFigures SeismicMonitor::figures() const {
  const SeismicSums& sums = extraction_.sums();
  SeismicFigures figures;
  figures.events = sums.event_count;
  figures.seismic_moment = sums.event_moment;
  figures.greatest_moment = sums.greatest_moment;
  figures.aseismic_moment = sums.aseismic_sum;
  figures.source_moment = sums.raw;
  return figures;
}

}  // namespace fissura::coupler
