// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "tests/coupler/seismicity/sample_sources.hpp"

using namespace fissura;
using namespace fissura::coupler;
using namespace fissura::coupler::test;

namespace {

/// Slips of the same joint, each a millisecond long, with a pause between.
std::vector<SourceRecord> bursts(int count, double pause) {
  std::vector<SourceRecord> records;
  for (int k = 0; k < count; ++k) records.push_back(slip_record(7, k * (1e-3 + pause), {0, 0}));
  return records;
}

bool heard(const ExtractionControls& controls, const SourceRecord& record) {
  return events_of(controls, {record}).size() == 1;
}

}  // namespace

TEST_CASE("slip is heard from v_s on, in the rock's own mass", "[coupler][seismicity]") {
  const ExtractionControls controls = shale_controls();
  SourceRecord record = slip_record(1, 0, {0, 0});
  record.peak_rate = controls.thresholds.slip_rate;
  CHECK(heard(controls, record));
  record.peak_rate *= 1 - 1e-9;
  CHECK_FALSE(heard(controls, record));
  record.mass_scale = 1e4;
  record.peak_rate = 0.01 * controls.thresholds.slip_rate;
  CHECK(heard(controls, record));
  record.peak_rate *= 1 - 1e-9;
  CHECK_FALSE(heard(controls, record));
}

TEST_CASE("slip is heard only if it costs shear traction, over all of the source", "[coupler][seismicity]") {
  const ExtractionControls controls = shale_controls();
  SourceRecord record = slip_record(1, 0, {0, 0});
  record.shear_after = record.shear_before - controls.thresholds.stress_drop;
  CHECK(heard(controls, record));
  record.shear_after += 1;
  CHECK_FALSE(heard(controls, record));
  // The traction may change its sign.
  record.shear_after = -record.shear_before;
  CHECK_FALSE(heard(controls, record));

  std::vector<SourceRecord> records = bursts(4, 1e-4);
  for (std::size_t k = 0; k < records.size(); ++k) {
    records[k].shear_before = 2e6 - 3e3 * static_cast<double>(k);
    records[k].shear_after = records[k].shear_before - 3e3;
  }
  CHECK(events_of(controls, records).size() == 1);
  records.pop_back();
  CHECK(events_of(controls, records).empty());
}

TEST_CASE("rock that fails is heard at any rate, unless a rate is asked for", "[coupler][seismicity]") {
  ExtractionControls controls = shale_controls();
  SourceRecord record = joint_record(SourceKind::new_crack, 1, 0, {0, 0}, {0, 1e-4});
  record.peak_rate = 1e-7;
  record.mass_scale = 4;
  for (const SourceKind kind : {SourceKind::new_crack, SourceKind::bulk_tension, SourceKind::bulk_shear,
                                SourceKind::bulk_compaction}) {
    record.kind = kind;
    controls.thresholds.failure_rate = 0;
    CHECK(heard(controls, record));
    controls.thresholds.failure_rate = 2e-7;
    CHECK(heard(controls, record));
    controls.thresholds.failure_rate = 2.001e-7;
    CHECK_FALSE(heard(controls, record));
  }
}

TEST_CASE("what moves without failing is aseismic at any rate", "[coupler][seismicity]") {
  Extraction extraction(shale_controls());
  SourceRecord record = joint_record(SourceKind::contact_opening, 1, 0, {0, 0}, {0, 1e-3});
  record.failing = false;
  record.peak_rate = 10;
  CHECK(extraction.advance(1, {record}).empty());
  CHECK(extraction.sums().aseismic == record.moment);
  CHECK(extraction.sums().aseismic_sum == scalar_moment(record.moment));
  CHECK(extraction.finish().empty());
}

TEST_CASE("pauses of one joint up to rest_time belong to one source, longer ones part it",
          "[coupler][seismicity]") {
  ExtractionControls controls = shale_controls();
  controls.thresholds.rest_time = 0.25;
  controls.thresholds.cluster_time = 1e-3;
  const std::vector<SeismicEvent> together = events_of(controls, bursts(5, 0.249));
  REQUIRE(together.size() == 1);
  CHECK(together[0].records == 5);
  CHECK(together[0].sources == 1);
  CHECK(together[0].slip == Approx(5e-3).epsilon(1e-12));
  CHECK(together[0].area == thickness);
  CHECK(together[0].duration == Approx(4 * 0.25 + 1e-3).epsilon(1e-12));

  const std::vector<SeismicEvent> apart = events_of(controls, bursts(5, 0.251));
  REQUIRE(apart.size() == 5);
  for (const SeismicEvent& event : apart) CHECK(event.slip == Approx(1e-3).epsilon(1e-12));
}

TEST_CASE("a pause of just rest_time is within the source", "[coupler][seismicity]") {
  ExtractionControls controls = shale_controls();
  controls.thresholds.rest_time = 0.25;
  SourceRecord first = slip_record(7, 0, {0, 0}), second = slip_record(7, 0.5, {0, 0});
  first.end = first.centroid_time = 0.25;
  second.element_size = 2;
  const std::vector<SeismicEvent> events = events_of(controls, {first, second});
  REQUIRE(events.size() == 1);
  CHECK(events[0].element_size == 1);
  CHECK(events[0].radius_of_clustering == 3);
  CHECK(events[0].time_of_clustering == Approx(3 / controls.shear_wave_speed).epsilon(1e-12));
}

TEST_CASE("slow motion that is told of later goes on with its source, for a while", "[coupler][seismicity]") {
  ExtractionControls controls = shale_controls();
  controls.thresholds.rest_time = 0.01;
  controls.thresholds.cluster_time = 1e-3;
  const double limit = 1e-3 + 0.01 + 150 / controls.shear_wave_speed;
  SourceRecord late = slip_record(7, 1.2e-3, {0, 0});
  for (const double share : {1 - 1e-9, 1 + 1e-9}) {
    late.end = late.centroid_time = share * limit;
    CHECK(events_of(controls, {slip_record(7, 0, {0, 0}), late}).size() == (share < 1 ? 1 : 2));
  }
}

TEST_CASE("a joint that fails twice in one event counts its area once and its slip twice",
          "[coupler][seismicity]") {
  ExtractionControls controls = shale_controls();
  controls.thresholds.rest_time = 1e-3;
  controls.thresholds.cluster_time = 1;
  const std::vector<SeismicEvent> events = events_of(controls, bursts(3, 0.25));
  REQUIRE(events.size() == 1);
  CHECK(events[0].sources == 1);
  CHECK(events[0].records == 3);
  CHECK(events[0].area == thickness);
  CHECK(events[0].slip == Approx(3e-3).epsilon(1e-12));
  CHECK(events[0].stress_drop == Approx(3e6).epsilon(1e-12));
}

TEST_CASE(
    "without a rest_time a joint rests after a hundred passages of a shear wave over r_c in its scaled mass",
    "[coupler][seismicity]") {
  const ExtractionControls controls = shale_controls();
  for (const double scale : {1.0, 1e4}) {
    const double crossing = 1.5 / controls.shear_wave_speed * std::sqrt(scale);
    for (const double share : {0.999, 1.001}) {
      std::vector<SourceRecord> records = bursts(3, share * 100 * crossing);
      for (SourceRecord& record : records) {
        record.mass_scale = scale;
        record.end = record.centroid_time = record.begin + 1e-3;
      }
      const std::vector<SeismicEvent> events = events_of(controls, records);
      CHECK(events.size() == (share < 1 ? 1 : 3));
      CHECK(events[0].time_of_clustering == Approx(crossing).epsilon(1e-12));
    }
  }
}

TEST_CASE("a joint that softens over many intervals is one event with one time", "[coupler][seismicity]") {
  Extraction extraction(shale_controls());
  std::vector<SeismicEvent> events;
  for (int k = 0; k < 1000; ++k) {
    SourceRecord record = joint_record(SourceKind::new_crack, 3, 1e-2 * k, {0, 0}, {0, 1e-7});
    record.end = record.begin + 1e-2;
    record.centroid_time = record.begin + 5e-3;
    for (const SeismicEvent& event : extraction.advance(record.end, {record})) events.push_back(event);
  }
  CHECK(events.empty());
  events = extraction.advance(20, {});
  REQUIRE(events.size() == 1);
  CHECK(events[0].opening == Approx(1e-4).epsilon(1e-12));
  CHECK(events[0].centroid_time == Approx(5).epsilon(1e-12));
  CHECK(events[0].duration == Approx(10).epsilon(1e-12));
}

TEST_CASE("elements of another geometry are other elements; joints keep their numbers",
          "[coupler][seismicity]") {
  SourceRecord first = slip_record(7, 0, {0, 0}), second = slip_record(7, 5e-4, {0, 0});
  second.geometry = 1;
  SeismicEvent event = events_of(shale_controls(), {first, second}).at(0);
  CHECK(event.sources == 1);
  CHECK(event.area == thickness);
  first.kind = second.kind = SourceKind::bulk_shear;
  event = events_of(shale_controls(), {first, second}).at(0);
  CHECK(event.sources == 2);
  CHECK(event.area == 2 * thickness);
}

TEST_CASE("a joint and an element of the same number are two sources", "[coupler][seismicity]") {
  SourceRecord element = slip_record(7, 0, {0, 0});
  element.kind = SourceKind::bulk_shear;
  CHECK(events_of(shale_controls(), {element, slip_record(7, 0, {0, 0})}).at(0).sources == 2);
}
