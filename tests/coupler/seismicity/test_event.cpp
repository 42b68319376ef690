// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "tests/coupler/seismicity/sample_sources.hpp"

using namespace fissura;
using namespace fissura::coupler;
using namespace fissura::coupler::test;

namespace {

constexpr double exact = 1e-12;

/// Five neighbouring joints that slip one after the other, each more than the one before.
std::vector<SourceRecord> growing_slip() {
  std::vector<SourceRecord> records;
  for (int k = 0; k < 5; ++k) {
    SourceRecord record = joint_record(SourceKind::contact_slip, static_cast<std::uint64_t>(k), 1e-4 * k,
                                       {10.0 + k, 3}, {1e-4 * (k + 1), 0});
    record.fluid_pressure = 1e6 * k;
    record.peak_rate = 0.1 * (k + 1);
    record.shear_after = 1e6 + 1e5 * k;
    record.interval = static_cast<std::uint64_t>(k);
    records.push_back(record);
  }
  return records;
}

}  // namespace

TEST_CASE("an event is the sum of its sources, its centre weighted by their moments",
          "[coupler][seismicity]") {
  const SeismicEvent event = events_of(shale_controls(), growing_slip()).at(0);
  CHECK(event.id == 1);
  CHECK(event.sources == 5);
  CHECK(event.records == 5);
  CHECK(event.interval == 4);
  const double size = shear_modulus * thickness * 1.5e-3;
  CHECK(event.moment[3] == Approx(size).epsilon(exact));
  CHECK(event.scalar_moment == Approx(size).epsilon(exact));
  CHECK(event.scalar_sum == Approx(size).epsilon(exact));
  CHECK(event.coherence == Approx(1).epsilon(exact));
  CHECK(*event.magnitude == Approx(moment_magnitude(size)).margin(exact));
  CHECK(event.type == EventType::shear);

  // Weights 1 to 5 at places 0 to 4: mean 40/15, mean square 130/15.
  const double mean = 40.0 / 15;
  CHECK(event.centroid[0] == Approx(10 + mean).epsilon(exact));
  CHECK(event.centroid[1] == Approx(3).epsilon(exact));
  CHECK(event.centroid_time == Approx(5e-4 + 1e-4 * mean).epsilon(exact));
  CHECK(event.radius == Approx(std::sqrt(130.0 / 15 - mean * mean)).epsilon(exact));
  CHECK(event.origin == std::array<double, 2>{10, 3});
  CHECK(event.origin_time == 0);
  CHECK(event.duration == Approx(1.4e-3).epsilon(exact));
  CHECK(event.length == Approx(5).epsilon(exact));
  CHECK(event.area == Approx(5 * thickness).epsilon(exact));
  CHECK(event.slip == Approx(3e-4).epsilon(exact));
  CHECK(event.opening == Approx(0).margin(1e-18));
  CHECK(event.stress_drop == Approx(8e5).epsilon(exact));
  CHECK(event.fluid_pressure == Approx(2e6).epsilon(exact));
  CHECK(event.peak_rate == 0.5);
  CHECK(event.thickness == thickness);
  CHECK(event.radius_of_clustering == 1.5);
  CHECK(event.fracture == SourceFracture::natural);
}

TEST_CASE("slip is signed by the tangent (n_y, -n_x) of records and event alike", "[coupler][seismicity]") {
  // The event's normal is (0, -1): its tangent points to -x, and that is where its plus side, below, went.
  const SeismicEvent right = events_of(shale_controls(), {slip_record(1, 0, {0, 0})}).at(0);
  CHECK(right.normal[0] == Approx(0).margin(exact));
  CHECK(right.normal[1] == Approx(-1).epsilon(exact));
  SourceRecord record = slip_record(1, 0, {0, 0});
  record.normal = {0, -1};
  record.jump = {-1e-3, 0};
  CHECK(events_of(shale_controls(), {record}).at(0).slip == right.slip);
  CHECK(right.slip == 1e-3);
}

TEST_CASE("an event is on the line where most of its moment lies", "[coupler][seismicity]") {
  std::vector<SourceRecord> records = growing_slip();
  for (std::size_t k = 0; k < 5; ++k) records[k].line = k < 3 ? 4 : 9;
  records[4].fracture = SourceFracture::grown;
  // 6 parts on line 4, 4 parts on line 9 of one kind, 5 parts of another.
  CHECK(events_of(shale_controls(), records).at(0).line == 4);
  records[3].fracture = SourceFracture::grown;
  const SeismicEvent event = events_of(shale_controls(), records).at(0);
  CHECK(event.line == 9);
  CHECK(event.fracture == SourceFracture::grown);
}

TEST_CASE("two equal and opposite slips cancel: no magnitude, coherence 0", "[coupler][seismicity]") {
  SourceRecord back = joint_record(SourceKind::contact_slip, 2, 0, {1, 0}, {-1e-3, 0});
  const SeismicEvent event = events_of(shale_controls(), {slip_record(1, 0, {0, 0}), back}).at(0);
  CHECK(event.scalar_moment == 0);
  CHECK(event.scalar_sum == Approx(2 * scalar_moment(back.moment)).epsilon(exact));
  CHECK(event.coherence == 0);
  CHECK_FALSE(event.magnitude);
  CHECK(event.type == EventType::mixed);
  CHECK(event.shares.dc == 0);

  // Cancelling but for rounding.
  for (double& component : back.moment) component *= 1 + 1e-15;
  CHECK_FALSE(events_of(shale_controls(), {slip_record(1, 0, {0, 0}), back}).at(0).magnitude);
}

TEST_CASE("types follow the shares of the moment", "[coupler][seismicity]") {
  const auto type_of = [](std::array<double, 2> jump) {
    return events_of(shale_controls(), {joint_record(SourceKind::new_crack, 1, 0, {0, 0}, jump)}).at(0).type;
  };
  CHECK(type_of({1e-3, 0}) == EventType::shear);
  CHECK(type_of({0, 1e-3}) == EventType::tensile);
  CHECK(type_of({0, -1e-3}) == EventType::closing);
  // Slopes of 10 and 13 degrees: double couples of 64 % and 56 %, isotropic shares of 18 % and 22 %.
  CHECK(type_of({std::cos(0.1745), std::sin(0.1745)}) == EventType::shear);
  CHECK(type_of({std::cos(0.2269), std::sin(0.2269)}) == EventType::tensile);
  SourceRecord explosion = joint_record(SourceKind::new_crack, 1, 0, {0, 0}, {});
  explosion.moment = {1e6, 1e6, 1e6, 0};
  CHECK(events_of(shale_controls(), {explosion}).at(0).type == EventType::mixed);
  CHECK(std::string(name(EventType::shear)) == "shear");
  CHECK(std::string(name(EventType::tensile)) == "tensile");
  CHECK(std::string(name(EventType::closing)) == "closing");
  CHECK(std::string(name(EventType::mixed)) == "mixed");
}

TEST_CASE("an element that cracks has the area V / h and the opening of its moment",
          "[coupler][seismicity]") {
  SourceRecord record = joint_record(SourceKind::bulk_tension, 1, 0, {0, 0}, {0, 1e-4});
  record.element_size = 0.5;
  record.extent = 0.5 * thickness;
  record.normal = {0.6, 0.8};
  record.moment = moment_of_jump(thickness, record.normal, {0.6e-4, 0.8e-4}, lame_constant, shear_modulus);
  record.jump = {};
  const SeismicEvent event = events_of(shale_controls(), {record}).at(0);
  CHECK(event.area == Approx(thickness).epsilon(exact));
  CHECK(event.opening == Approx(1e-4).epsilon(exact));
  CHECK(event.slip == Approx(0).margin(1e-16));
  CHECK(event.length == 0.5);

  record.kind = SourceKind::bulk_shear;
  record.moment = moment_of_jump(thickness, record.normal, {0.8e-4, -0.6e-4}, lame_constant, shear_modulus);
  CHECK(events_of(shale_controls(), {record}).at(0).slip == Approx(1e-4).epsilon(exact));
}

TEST_CASE("one element is an event of its own size", "[coupler][seismicity]") {
  const SeismicEvent event = events_of(shale_controls(), {slip_record(1, 0, {0, 0})}).at(0);
  CHECK(event.radius == 0.5);
  CHECK(event.length == 1);
}

TEST_CASE("an equidimensional event is as deep as it is long; the sums stay those of the layer",
          "[coupler][seismicity]") {
  ExtractionControls controls = shale_controls();
  const SeismicEvent layer = events_of(controls, growing_slip()).at(0);
  controls.thresholds.thickness = SourceThickness::equidimensional;
  Extraction extraction(controls);
  extraction.advance(1, growing_slip());
  const SeismicEvent event = events_of(controls, growing_slip()).at(0);
  CHECK(event.thickness == Approx(5).epsilon(exact));
  CHECK(event.scalar_moment == Approx(0.5 * layer.scalar_moment).epsilon(exact));
  CHECK(event.moment[3] == Approx(0.5 * layer.moment[3]).epsilon(exact));
  CHECK(event.area == Approx(0.5 * layer.area).epsilon(exact));
  CHECK(event.coherence == Approx(layer.coherence).epsilon(exact));
  CHECK(*event.magnitude == Approx(*layer.magnitude + std::log10(0.5) * 2 / 3).margin(exact));
  CHECK(extraction.sums().event_moment == Approx(layer.scalar_moment).epsilon(exact));
  CHECK(extraction.sums().events == extraction.sums().raw);
}
