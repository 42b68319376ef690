// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <random>

#include "coupler/seismicity/clustering.hpp"
#include "tests/coupler/seismicity/sample_sources.hpp"

using namespace fissura;
using namespace fissura::coupler;
using namespace fissura::coupler::test;

namespace {

constexpr int seeds = 40;

/// A hundred joints in a crooked row, in no order of time, neighbours just within r_c of each other.
std::vector<SourceRecord> chain_of_joints() {
  std::vector<SourceRecord> records;
  double x = 0, y = 0;
  for (std::uint64_t k = 0; k < 100; ++k) {
    records.push_back(slip_record(k, 1e-7 * static_cast<double>(k * 37 % 100), {x, y}));
    const double angle = 0.5 * std::sin(0.3 * static_cast<double>(k));
    x += 1.499 * std::cos(angle);
    y += 1.499 * std::sin(angle);
  }
  return records;
}

/// Joints that fail once each, in a square, some in the same place; radii differ eightfold, speeds of waves
/// tenfold.
std::vector<SourceRecord> scattered_joints(std::uint64_t seed, std::size_t count) {
  std::mt19937_64 random(seed);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<SourceRecord> records;
  for (std::size_t k = 0; k < count; ++k) {
    const SourceKind kind = uniform() < 0.5 ? SourceKind::contact_slip : SourceKind::new_crack;
    SourceRecord record =
        joint_record(kind, k, uniform(), {std::floor(40 * uniform()), std::floor(40 * uniform())},
                     {1e-3 * uniform(), 1e-3 * uniform()});
    record.end = record.centroid_time = record.begin;
    record.element_size = std::exp2(3 * uniform() - 1.5);
    record.mass_scale = uniform() < 0.5 ? 1e4 : 1e6;
    records.push_back(record);
  }
  return records;
}

/// Clusters of records that are a source each, by the rule and by all pairs.
std::vector<std::vector<std::size_t>> clusters_of_pairs(const std::vector<SourceRecord>& records,
                                                        double shear_wave_speed) {
  const std::size_t count = records.size();
  std::vector<std::size_t> cluster(count);
  std::iota(cluster.begin(), cluster.end(), 0);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j) {
      const SourceRecord &a = records[i], &b = records[j];
      const bool slip = a.kind == SourceKind::contact_slip, other = b.kind == SourceKind::contact_slip;
      if (slip != other || b.centroid_time < a.centroid_time) continue;
      const double radius = 1.5 * std::max(a.element_size, b.element_size);
      const double wave = 1.5 * a.element_size * std::sqrt(a.mass_scale) / shear_wave_speed;
      if (std::hypot(a.position[0] - b.position[0], a.position[1] - b.position[1]) > radius) continue;
      if (b.centroid_time - a.centroid_time > wave) continue;
      const std::size_t from = cluster[j], to = cluster[i];
      std::replace(cluster.begin(), cluster.end(), from, to);
    }
  std::vector<std::vector<std::size_t>> clusters(count);
  for (std::size_t i = 0; i < count; ++i) clusters[cluster[i]].push_back(i);
  std::erase_if(clusters, [](const auto& members) { return members.empty(); });
  return clusters;
}

/// What tells clusters apart: begin and end of what is in them, and how much of it.
using Fingerprint = std::array<double, 3>;

std::vector<Fingerprint> expected_events(const std::vector<SourceRecord>& records, double shear_wave_speed) {
  std::vector<Fingerprint> expected;
  for (const std::vector<std::size_t>& members : clusters_of_pairs(records, shear_wave_speed)) {
    double begin = 1e9, end = 0;
    for (const std::size_t i : members) {
      begin = std::min(begin, records[i].begin);
      end = std::max(end, records[i].end);
    }
    expected.push_back({begin, end - begin, static_cast<double>(members.size())});
  }
  std::sort(expected.begin(), expected.end());
  return expected;
}

std::vector<Fingerprint> found_events(const std::vector<SeismicEvent>& events) {
  std::vector<Fingerprint> found;
  for (const SeismicEvent& event : events)
    found.push_back({event.origin_time, event.duration, static_cast<double>(event.sources)});
  std::sort(found.begin(), found.end());
  return found;
}

std::size_t events_of_two(ExtractionControls controls, double distance, double delay) {
  return events_of(controls, {slip_record(1, 0, {0, 0}), slip_record(2, delay, {distance, 0})}).size();
}

}  // namespace

TEST_CASE("sources are one event up to r_c and t_c, both inclusive", "[coupler][seismicity]") {
  ExtractionControls controls = shale_controls();
  controls.thresholds.cluster_radius = 2.5;
  controls.thresholds.cluster_time = 0.125;
  for (const double share : {1 - 1e-9, 1.0}) {
    CHECK(events_of_two(controls, 2.5 * share, 0) == 1);
    CHECK(events_of_two(controls, 0, 0.125 * share) == 1);
    CHECK(events_of_two(controls, 2.5 * share, 0.125 * share) == 1);
  }
  CHECK(events_of_two(controls, 2.5 * (1 + 1e-9), 0) == 2);
  CHECK(events_of_two(controls, 0, 0.125 * (1 + 1e-9)) == 2);
}

TEST_CASE("the mesh gives r_c, the shear wave t_c", "[coupler][seismicity]") {
  const ExtractionControls controls = shale_controls();
  CHECK(events_of_two(controls, 1.5 * (1 - 1e-9), 0) == 1);
  CHECK(events_of_two(controls, 1.5 * (1 + 1e-9), 0) == 2);
  const double crossing = 1.5 / controls.shear_wave_speed;
  CHECK(events_of_two(controls, 1, crossing * (1 - 1e-9)) == 1);
  CHECK(events_of_two(controls, 1, crossing * (1 + 1e-9)) == 2);
}

TEST_CASE("the coarser of two meshes reaches both ways; the earlier source's mass gives the wave",
          "[coupler][seismicity]") {
  const ExtractionControls controls = shale_controls();
  SourceRecord early = slip_record(1, 0, {0, 0}), late = slip_record(2, 1e-4, {5, 0});
  early.element_size = 4;
  CHECK(events_of(controls, {early, late}).size() == 1);
  std::swap(early.element_size, late.element_size);
  CHECK(events_of(controls, {early, late}).size() == 1);

  late = slip_record(2, 30e-3, {1, 0});
  late.mass_scale = 1e4;
  CHECK(events_of(controls, {early, late}).size() == 2);
  std::swap(early.mass_scale, late.mass_scale);
  CHECK(events_of(controls, {early, late}).size() == 1);
}

TEST_CASE("shear and tensile sources in one place are two events", "[coupler][seismicity]") {
  const SourceRecord slip = slip_record(1, 0, {0, 0});
  const SourceRecord crack = joint_record(SourceKind::new_crack, 2, 0, {0, 0}, {0, 1e-3});
  CHECK(events_of(shale_controls(), {slip, crack}).size() == 2);
}

TEST_CASE("a chain of neighbours is one event, the same bits for any order of the records",
          "[coupler][seismicity]") {
  std::vector<SourceRecord> records = chain_of_joints();
  const std::vector<SeismicEvent> events = events_of(shale_controls(), records);
  REQUIRE(events.size() == 1);
  CHECK(events[0].sources == 100);
  for (int seed = 0; seed < seeds; ++seed) {
    std::shuffle(records.begin(), records.end(), std::mt19937_64(static_cast<std::uint64_t>(seed)));
    REQUIRE(bytes_of(events_of(shale_controls(), records)) == bytes_of(events));
  }
  records.erase(std::find_if(records.begin(), records.end(), [](const auto& r) { return r.entity == 50; }));
  CHECK(events_of(shale_controls(), records).size() == 2);
}

TEST_CASE("records that only differ in what they lost are taken in one order", "[coupler][seismicity]") {
  std::vector<SourceRecord> records(50, slip_record(1, 0, {0, 0}));
  for (std::size_t k = 0; k < records.size(); ++k)
    records[k].shear_before += 1e5 * std::sin(static_cast<double>(k));
  const std::vector<SeismicEvent> events = events_of(shale_controls(), records);
  for (int seed = 0; seed < seeds; ++seed) {
    std::shuffle(records.begin(), records.end(), std::mt19937_64(static_cast<std::uint64_t>(seed)));
    REQUIRE(bytes_of(events_of(shale_controls(), records)) == bytes_of(events));
  }
}

TEST_CASE("a source is found again among thousands that came after it", "[coupler][seismicity]") {
  ExtractionControls controls = shale_controls();
  controls.thresholds.cluster_time = 1;
  constexpr std::uint64_t places = 6000;
  std::vector<SourceRecord> records;
  for (std::uint64_t k = 0; k < 2 * places; ++k)
    records.push_back(slip_record(k, (k < places ? 0 : 0.5) + 1e-5 * static_cast<double>(k % places),
                                  {10.0 * static_cast<double>(k % places), 0}));
  const std::vector<SeismicEvent> events = events_of(controls, records);
  CHECK(events.size() == places);
  CHECK(std::all_of(events.begin(), events.end(),
                    [](const SeismicEvent& event) { return event.sources == 2; }));
}

TEST_CASE("a cluster comes out in the order of its sources", "[coupler][seismicity]") {
  Clustering clustering;
  for (int k = 0; k < 6; ++k) {
    Source source;
    source.number = static_cast<std::uint64_t>(k);
    source.time = k;
    source.reach = 10;
    source.cluster_radius = 1;
    // Two apart, then those between.
    source.position = {k < 2 ? 1.5 * k : k == 5 ? 0.75 : -k, 0};
    clustering.add(source);
  }
  const auto clusters = clustering.take_closed(11);
  REQUIRE(clusters.size() == 2);
  for (const std::vector<Source>& sources : clusters)
    for (std::size_t k = 1; k < sources.size(); ++k) CHECK(sources[k - 1].number < sources[k].number);
}

TEST_CASE("clusters are those of all pairs", "[coupler][seismicity]") {
  const ExtractionControls controls = shale_controls();
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const std::vector<SourceRecord> records = scattered_joints(seed, 400);
    const std::vector<SeismicEvent> events = events_of(controls, records);
    // Neither all apart nor all in one.
    CHECK(events.size() > 20);
    CHECK(events.size() < 380);
    REQUIRE(found_events(events) == expected_events(records, controls.shear_wave_speed));
  }
}

TEST_CASE("a cluster closes when no source can join it any more", "[coupler][seismicity]") {
  ExtractionControls controls = shale_controls();
  controls.thresholds.cluster_time = 1;
  controls.thresholds.rest_time = 0.1;
  Extraction extraction(controls);
  CHECK(extraction.advance(0.01, {slip_record(1, 0, {0, 0})}).empty());
  CHECK(extraction.advance(1, {}).empty());
  CHECK(extraction.advance(1.001, {}).empty());
  CHECK(extraction.advance(1.0011, {}).size() == 1);
}

TEST_CASE("a source that lasts keeps open what it may still join", "[coupler][seismicity]") {
  ExtractionControls controls = shale_controls();
  controls.thresholds.cluster_time = 0.1;
  controls.thresholds.rest_time = 0.5;
  Extraction extraction(controls);
  // One joint slips from 0 on, most of it at first; its neighbour at 0.05.
  CHECK(extraction.advance(0.06, {slip_record(1, 0, {0, 0}), slip_record(2, 0.05, {1, 0})}).empty());
  for (int k = 1; k <= 10; ++k) {
    SourceRecord record = slip_record(1, 0.4 * k, {0, 0});
    for (double& component : record.moment) component *= 1e-3;
    CHECK(extraction.advance(0.4 * k + 0.1, {record}).empty());
  }
  const std::vector<SeismicEvent> events = extraction.advance(5, {});
  REQUIRE(events.size() == 1);
  CHECK(events[0].sources == 2);
  CHECK(events[0].duration == Approx(4.001).epsilon(1e-12));
}

TEST_CASE("events are numbered in the order of closing", "[coupler][seismicity]") {
  const std::vector<SeismicEvent> events = events_of(shale_controls(), random_records(3, 200));
  REQUIRE(events.size() > 100);
  for (std::size_t k = 0; k < events.size(); ++k) CHECK(events[k].id == k + 1);
}
