// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/extraction.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "common/errors.hpp"
#include "tests/coupler/seismicity/sample_sources.hpp"

using namespace fissura;
using namespace fissura::coupler;
using namespace fissura::coupler::test;

namespace {

constexpr int intervals = 300;

/// The records in calls at some of the coupling times, each call shuffled.
class Feed {
 public:
  Feed(const std::vector<SourceRecord>& records, std::uint64_t seed, std::uint64_t longest)
      : records_(records), random_(seed), longest_(longest) {}

  /// @returns whether anything was left
  bool next(Extraction& extraction, std::vector<SeismicEvent>& events) {
    if (interval_ >= intervals) return false;
    interval_ += 1 + random_() % longest_;
    const double time = random_interval * static_cast<double>(interval_);
    std::vector<SourceRecord> call;
    for (; taken_ < records_.size() && records_[taken_].interval <= interval_; ++taken_)
      call.push_back(records_[taken_]);
    std::shuffle(call.begin(), call.end(), random_);
    for (const SeismicEvent& event : extraction.advance(time, call)) events.push_back(event);
    return true;
  }

 private:
  const std::vector<SourceRecord>& records_;
  std::mt19937_64 random_;
  std::uint64_t longest_;  // call, in intervals
  std::uint64_t interval_ = 0;
  std::size_t taken_ = 0;
};

void append(std::vector<SeismicEvent>& events, const std::vector<SeismicEvent>& more) {
  events.insert(events.end(), more.begin(), more.end());
}

/// |raw - aseismic - events - open| over the scalar sum of everything.
double discrepancy(const Extraction& extraction, double scalar_sum) {
  const SeismicSums& sums = extraction.sums();
  const PlaneTensor open = extraction.open_moment();
  double greatest = 0;
  for (std::size_t i = 0; i < 4; ++i)
    greatest = std::max(greatest, std::abs(sums.raw[i] - sums.aseismic[i] - sums.events[i] - open[i]));
  return greatest / scalar_sum;
}

ExtractionControls narrow_controls() {
  ExtractionControls controls = shale_controls();
  controls.thresholds.cluster_time = 0.02;
  controls.thresholds.rest_time = 0.015;
  return controls;
}

ExtractionControls short_rest() {
  ExtractionControls controls = shale_controls();
  controls.thresholds.rest_time = 1e-3;
  return controls;
}

}  // namespace

TEST_CASE("events do not depend on how the records are split over calls", "[coupler][seismicity]") {
  for (const ExtractionControls& controls : {shale_controls(), short_rest(), narrow_controls()}) {
    const std::vector<SourceRecord> records = random_records(11, intervals);
    const std::vector<SeismicEvent> together = events_of(controls, records);
    const bool rests = controls.thresholds.rest_time > 0;
    if (rests) REQUIRE(together.size() > 100);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      Extraction extraction(controls);
      std::vector<SeismicEvent> events;
      for (Feed feed(records, seed, 1 + seed); feed.next(extraction, events);) {
      }
      if (rests) CHECK(events.size() > together.size() / 2);
      append(events, extraction.finish());
      REQUIRE(bytes_of(events) == bytes_of(together));
    }
  }
}

TEST_CASE("an extraction that is saved and restored in mid-cluster goes on with the same bits",
          "[coupler][seismicity]") {
  for (const ExtractionControls& controls : {shale_controls(), short_rest(), narrow_controls()}) {
    const std::vector<SourceRecord> records = random_records(12, intervals);
    const std::vector<SeismicEvent> whole = events_of(controls, records);
    int in_mid_cluster = 0;
    Extraction extraction(controls);
    std::vector<SeismicEvent> events;
    for (Feed feed(records, 4, 3); feed.next(extraction, events);) {
      const std::vector<std::byte> saved = extraction.save();
      const SeismicSums before = extraction.sums();
      const PlaneTensor open = extraction.open_moment();
      if (open != PlaneTensor{}) ++in_mid_cluster;
      extraction = Extraction(controls);
      extraction.restore(saved);
      CHECK(extraction.save() == saved);
      CHECK(extraction.open_moment() == open);
      CHECK(extraction.sums().raw == before.raw);
      CHECK(extraction.sums().aseismic_sum == before.aseismic_sum);
      CHECK(extraction.sums().event_count == before.event_count);
    }
    CHECK(in_mid_cluster > 10);
    append(events, extraction.finish());
    REQUIRE(bytes_of(events) == bytes_of(whole));
  }
}

TEST_CASE("nothing is lost: raw = aseismic + events + open at all times", "[coupler][seismicity]") {
  const std::vector<SourceRecord> records = random_records(13, intervals);
  Extraction extraction(narrow_controls());
  double scalar_sum = 0;
  for (const SourceRecord& record : records) scalar_sum += scalar_moment(record.moment);
  std::vector<SeismicEvent> events;
  for (Feed feed(records, 9, 3); feed.next(extraction, events);)
    REQUIRE(discrepancy(extraction, scalar_sum) < 1e-12);
  append(events, extraction.finish());
  CHECK(discrepancy(extraction, scalar_sum) < 1e-12);
  CHECK(extraction.open_moment() == PlaneTensor{});

  const SeismicSums& sums = extraction.sums();
  CHECK(sums.records == records.size());
  CHECK(sums.event_count == events.size());
  CHECK(sums.seismic_sum > 0);
  CHECK(sums.aseismic_sum > 0);
  CHECK(sums.seismic_sum + sums.aseismic_sum == Approx(scalar_sum).epsilon(1e-12));
  double event_moment = 0, greatest = 0;
  for (const SeismicEvent& event : events) {
    event_moment += event.scalar_moment;
    greatest = std::max(greatest, event.scalar_moment);
  }
  CHECK(sums.event_moment == Approx(event_moment).epsilon(1e-12));
  CHECK(sums.greatest_moment == greatest);
}

TEST_CASE("sums of terms that cancel keep their digits", "[coupler][seismicity]") {
  Extraction extraction(shale_controls());
  SourceRecord small = slip_record(1, 0, {0, 0});
  small.moment = {0, 0, 0, 1};
  SourceRecord great = slip_record(2, 2e-3, {50, 0}), back = slip_record(3, 4e-3, {100, 0});
  great.moment = {0, 0, 0, 1e20};
  back.moment = {0, 0, 0, -1e20};
  extraction.advance(1, {small, great, back});
  CHECK(extraction.sums().raw[3] == 1);
  CHECK(extraction.sums().events[3] == 1);
}

TEST_CASE("a record that ended before the last call counts as ending then", "[coupler][seismicity]") {
  Extraction before(narrow_controls()), extraction(narrow_controls());
  before.advance(5, {});
  extraction.restore(before.save());
  CHECK(extraction.advance(5.01, {slip_record(1, 1, {0, 0})}).empty());
  const std::vector<SeismicEvent> events = extraction.finish();
  REQUIRE(events.size() == 1);
  CHECK(events[0].origin_time == 1);
  CHECK(events[0].duration == 4);
}

TEST_CASE("bytes of something else are refused", "[coupler][seismicity]") {
  Extraction extraction(shale_controls());
  extraction.advance(1, random_records(1, 5));
  const std::vector<std::byte> saved = extraction.save();
  const auto refused = [&](const std::vector<std::byte>& bytes) {
    try {
      Extraction(shale_controls()).restore(bytes);
    } catch (const Error& error) {
      return error.code() == ExitCode::checkpoint_unusable;
    }
    return false;
  };
  CHECK(refused({}));
  CHECK(refused(std::vector<std::byte>(saved.size())));
  CHECK(refused({saved.begin(), saved.end() - 1}));
  std::vector<std::byte> longer = saved;
  longer.push_back(std::byte{0});
  CHECK(refused(longer));
  CHECK_FALSE(refused(saved));
}

TEST_CASE("a hundred thousand records in one call or in many give the same events", "[coupler][seismicity]") {
  const std::vector<SourceRecord> records = random_records(21, 8000);
  REQUIRE(records.size() > 80000);
  const std::vector<SeismicEvent> together = events_of(shale_controls(), records);
  Extraction extraction(shale_controls());
  std::vector<SeismicEvent> events;
  for (std::size_t taken = 0, k = 1; taken < records.size(); ++k) {
    std::vector<SourceRecord> call;
    for (; taken < records.size() && records[taken].interval == k; ++taken) call.push_back(records[taken]);
    append(events, extraction.advance(random_interval * static_cast<double>(k), call));
  }
  append(events, extraction.finish());
  CHECK(bytes_of(events) == bytes_of(together));
}

TEST_CASE("a saved extraction with any byte changed is refused, or goes on without harm", "[seismicity]") {
  Extraction sound(shale_controls());
  (void)sound.advance(0.03, random_records(1, 3));
  const std::vector<std::byte> saved = sound.save();
  std::size_t refused = 0;
  for (std::size_t i = 0; i < saved.size(); i += 3) {
    std::vector<std::byte> damaged = saved;
    damaged[i] ^= std::byte{0xc0};
    Extraction extraction(shale_controls());
    try {
      extraction.restore(damaged);
      (void)extraction.advance(1, {slip_record(1, 0.99, {0, 0})});
      (void)extraction.finish();
    } catch (const Error& fault) {
      CHECK(fault.code() == ExitCode::checkpoint_unusable);
      ++refused;
    }
  }
  CHECK(refused > 0);
}
