// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/extraction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/byte_archive.hpp"
#include "coupler/seismicity/clustering.hpp"
#include "coupler/seismicity/compensated_sum.hpp"
#include "coupler/seismicity/event_of_sources.hpp"
#include "coupler/seismicity/source_chains.hpp"

namespace fissura::coupler {

namespace {

constexpr std::uint64_t format = 0x31305854534946ull;  // "FISTX01", changes with what is saved

PlaneTensor operator+(const PlaneTensor& a, const PlaneTensor& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
}

// Records after which a call closes what it can, to keep little in memory.
constexpr std::size_t stretch = 4096;

/// The record, ended not before `time`: clusters that ended before are gone.
SourceRecord since(double time, SourceRecord record) {
  record.end = std::max(record.end, time);
  return record;
}

/// Sums in the order of what they sum; those of records and of sources are kept apart, so that their bits do
/// not depend on how the records were split over calls.
struct Accounts {
  TensorSum raw, slow_records, quiet_sources, events;
  CompensatedSum event_moment, seismic_sum, slow_record_sum, quiet_source_sum;
  double greatest_moment = 0;
  std::uint64_t records = 0, event_count = 0;

  [[nodiscard]] SeismicSums sums() const {
    SeismicSums sums;
    sums.raw = raw.value();
    sums.aseismic = slow_records.value() + quiet_sources.value();
    sums.events = events.value();
    sums.event_moment = event_moment.value();
    sums.seismic_sum = seismic_sum.value();
    sums.aseismic_sum = slow_record_sum.value() + quiet_source_sum.value();
    sums.greatest_moment = greatest_moment;
    sums.records = records;
    sums.event_count = event_count;
    return sums;
  }
};

}  // namespace

class Extraction::State {
 public:
  explicit State(const ExtractionControls& controls)
      : rules_{controls.thresholds, controls.thickness, controls.lame, controls.shear,
               controls.shear_wave_speed},
        geography_(controls.geography),
        chains_(rules_) {}

  std::vector<SeismicEvent> advance(double time, const std::vector<SourceRecord>& records) {
    time = std::max(called_, time);
    const std::vector<std::uint32_t> order = order_of(records);
    std::vector<SeismicEvent> events;
    for (std::size_t i = 0; i < order.size(); ++i) {
      take(records[order[i]]);
      if ((i + 1) % stretch == 0) close(std::clamp(records[order[i]].end, called_, time), events);
    }
    called_ = time;
    close(called_, events);
    sums_ = accounts_.sums();
    return events;
  }

  std::vector<SeismicEvent> finish() {
    std::vector<SeismicEvent> events;
    close(std::numeric_limits<double>::infinity(), events);
    sums_ = accounts_.sums();
    return events;
  }

  [[nodiscard]] const SeismicSums& sums() const { return sums_; }

  [[nodiscard]] PlaneTensor open_moment() const {
    TensorSum open;
    chains_.add_to(open);
    for (const Source& source : waiting_.sources()) open.add(source.moment);
    for (const Source& source : clustering_.open_sources()) open.add(source.moment);
    return open.value();
  }

  [[nodiscard]] std::vector<std::byte> save() const {
    ByteWriter writer;
    writer.put(format);
    writer.put(called_);
    writer.put(accounts_);
    writer.put(chains_.open_sources());
    writer.put(waiting_.sources());
    writer.put(clustering_.open_sources());
    return writer.take();
  }

  void restore(const std::vector<std::byte>& bytes) {
    ByteReader reader(bytes);
    std::uint64_t found = 0;
    reader.get(found);
    if (found != format)
      throw Error(ExitCode::checkpoint_unusable, "the saved state is not one of the extraction of events");
    std::vector<OpenSource> open;
    std::vector<Source> waiting, clustered;
    reader.get(called_);
    reader.get(accounts_);
    reader.get(open);
    reader.get(waiting);
    reader.get(clustered);
    reader.end();
    require_possible(open, waiting, clustered);
    chains_ = SourceChains(rules_);
    chains_.put_back(open);
    waiting_ = {};
    for (const Source& source : waiting) waiting_.push(source);
    clustering_ = {};
    for (const Source& source : clustered) clustering_.add(source);
    sums_ = accounts_.sums();
  }

 private:
  void require_possible(const std::vector<OpenSource>& open, const std::vector<Source>& waiting,
                        const std::vector<Source>& clustered) const {
    const auto complete = [](const Source& source) { return is_possible(source, SourceStage::complete); };
    if (std::isnan(called_) ||
        !std::all_of(open.begin(), open.end(), [](const auto& source) { return source.is_possible(); }) ||
        !std::all_of(waiting.begin(), waiting.end(), complete) ||
        !std::all_of(clustered.begin(), clustered.end(), complete))
      throw Error(ExitCode::checkpoint_unusable,
                  "the saved extraction of events holds sources that cannot be");
  }

  void take(const SourceRecord& record) {
    ++accounts_.records;
    accounts_.raw.add(record.moment);
    if (rules_.seismic(record)) {
      chains_.add(since(called_, record), waiting_);
    } else {
      accounts_.slow_records.add(record.moment);
      accounts_.slow_record_sum.add(scalar_moment(record.moment));
    }
  }

  /// Closes what no record that ends at `time` or later can become a part of.
  void close(double time, std::vector<SeismicEvent>& events) {
    chains_.close_before(time, waiting_);
    const double watermark = std::min(time, chains_.earliest_time());
    for (; !waiting_.empty() && waiting_.first().time < watermark; waiting_.pop()) {
      const Source& source = waiting_.first();
      if (rules_.seismic(source)) {
        clustering_.add(source);
      } else {
        accounts_.quiet_sources.add(source.moment);
        accounts_.quiet_source_sum.add(source.scalar_sum);
      }
    }
    for (const std::vector<Source>& sources : clustering_.take_closed(watermark)) {
      events.push_back(event_of(sources, rules_, geography_));
      account(sources);
      events.back().id = accounts_.event_count;
    }
  }

  void account(const std::vector<Source>& sources) {
    TensorSum moment;
    for (const Source& source : sources) {
      moment.add(source.moment);
      accounts_.seismic_sum.add(source.scalar_sum);
    }
    const double scalar = scalar_moment(moment.value());
    accounts_.events.add(moment.value());
    accounts_.event_moment.add(scalar);
    accounts_.greatest_moment = std::max(accounts_.greatest_moment, scalar);
    ++accounts_.event_count;
  }

  SourceRules rules_;
  Geography geography_;
  SourceChains chains_;
  WaitingSources waiting_;
  Clustering clustering_;
  Accounts accounts_;
  SeismicSums sums_;
  double called_ = -std::numeric_limits<double>::infinity();  // time of the last call
};

Extraction::Extraction(const ExtractionControls& controls) : state_(std::make_unique<State>(controls)) {}
Extraction::~Extraction() = default;
Extraction::Extraction(Extraction&&) noexcept = default;
Extraction& Extraction::operator=(Extraction&&) noexcept = default;

std::vector<SeismicEvent> Extraction::advance(double time, const std::vector<SourceRecord>& records) {
  return state_->advance(time, records);
}

std::vector<SeismicEvent> Extraction::finish() {
  return state_->finish();
}

const SeismicSums& Extraction::sums() const {
  return state_->sums();
}

PlaneTensor Extraction::open_moment() const {
  return state_->open_moment();
}

std::vector<std::byte> Extraction::save() const {
  return state_->save();
}

void Extraction::restore(const std::vector<std::byte>& bytes) {
  state_->restore(bytes);
}

std::optional<double> seismic_fraction(const SeismicSums& sums) {
  const double all = sums.seismic_sum + sums.aseismic_sum;
  return all > 0 ? std::optional(sums.seismic_sum / all) : std::nullopt;
}

}  // namespace fissura::coupler
