// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/seismic_monitor.hpp"

#include <chrono>

namespace fissura::coupler {

namespace {

using Clock = std::chrono::steady_clock;

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

}  // namespace

SeismicMonitor::SeismicMonitor(const Case& run_case)
    : case_(run_case), extraction_(extraction_controls(run_case)) {}

void SeismicMonitor::begin(const std::filesystem::path& folder, const std::string& run_id,
                           const std::string& started) {
  if (!case_.seismicity.active) return;
  catalogue_.emplace(
      folder, CatalogueContext{run_id, case_.title, started, extraction_controls(case_), case_.georeference});
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
