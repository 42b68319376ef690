// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include "tests/common/case_fixture.hpp"

using namespace fissura;
using namespace fissura::test;

namespace {

const std::string seismic = R"([seismicity]
active = false
slip_rate = "2 mm/s"
stress_drop = "20 kPa"
failure_rate = "1e-4 m/s"
cluster_radius = "3 m"
cluster_time = "5 ms"
rest_time = "0.1 s"
thickness = "equidimensional"
maximum_records = 500
voxel_size = "4 m"
voxel_events = 2
)";

const std::string place = R"([georeference]
latitude = "-56.7 degree"
longitude = "123.456789 deg"
depth = "2.5 km"
start = "2026-01-31T12:00:00.25Z"
azimuth = "30 degree"
)";

CaseReading reading_of(const std::string& addition) {
  const Folder folder;
  folder.write("case.toml", valid_case + addition);
  return read_case({folder.path(), {}, {}});
}

/// One key of [seismicity] refused.
void check_key_refused(const std::string& line, const std::string& message) {
  check_addition_refused("[seismicity]\n" + line + "\n", "seismicity." + message);
}

/// `old` of the georeference replaced by `fresh`, refused.
void check_place_refused(const std::string& old, const std::string& fresh, const std::string& message) {
  check_addition_refused(replaced(place, old, fresh), "georeference." + message);
}

}  // namespace

TEST_CASE("a case may say how failures become events", "[common][case][seismicity]") {
  const Seismicity read = reading_of(seismic).value.seismicity;
  CHECK_FALSE(read.active);
  CHECK(read.slip_rate == 2e-3);
  CHECK(read.stress_drop == 2e4);
  CHECK(read.failure_rate == 1e-4);
  CHECK(read.cluster_radius == 3);
  CHECK(read.cluster_time == 5e-3);
  CHECK(read.rest_time == 0.1);
  CHECK(read.thickness == SourceThickness::equidimensional);
  CHECK(read.maximum_records == 500);
  CHECK(read.voxel_size == 4);
  CHECK(read.voxel_events == 2);
}

TEST_CASE("a case that says nothing has events by the mesh and no place on Earth",
          "[common][case][seismicity]") {
  const Case value = reading_of("").value;
  CHECK(value.seismicity.active);
  CHECK(value.seismicity.cluster_radius == 0);
  CHECK(value.seismicity.cluster_time == 0);
  CHECK(value.seismicity.thickness == SourceThickness::layer);
  CHECK_FALSE(value.georeference.has_value());
}

TEST_CASE("a place on Earth is kept in degrees as written, for a plan view or a section",
          "[common][case][seismicity]") {
  const Case plan = reading_of(place).value;
  REQUIRE(plan.georeference.has_value());
  CHECK(plan.georeference->latitude == -56.7);
  CHECK(plan.georeference->longitude == 123.456789);
  CHECK(plan.georeference->depth == 2500);
  CHECK(plan.georeference->start == "2026-01-31T12:00:00.25Z");
  CHECK(plan.georeference->azimuth == Approx(std::numbers::pi / 6));
  CHECK_FALSE(plan.georeference->section_azimuth.has_value());
  const Case section = reading_of(replaced(place, "\nazimuth", "\nsection_azimuth")).value;
  CHECK(section.georeference->section_azimuth.value() == Approx(std::numbers::pi / 6));
  CHECK(section.georeference->azimuth == 0);
}

TEST_CASE("each wrong value of [seismicity] is told with its place and range", "[common][case][seismicity]") {
  const std::string velocity = "expected a velocity with its unit such as \"2 m/s\", at least 0 m/s";
  const std::string length = "expected a length with its unit such as \"0.25 m\"";
  const std::string time = "expected a time with its unit such as \"10 s\"";
  check_key_refused("active = @1", "active: found 1, expected true or false");
  check_key_refused("slip_rate = @\"-1 m/s\"", "slip_rate: found \"-1 m/s\", " + velocity);
  check_key_refused("failure_rate = @\"-1 m/s\"", "failure_rate: found \"-1 m/s\", " + velocity);
  check_key_refused("stress_drop = @\"-1 Pa\"",
                    "stress_drop: found \"-1 Pa\", expected a stress or pressure with its unit such as \"10 "
                    "MPa\", at least 0 Pa");
  check_key_refused("cluster_radius = @\"0 m\"",
                    "cluster_radius: found \"0 m\", " + length + ", greater than 0 m");
  check_key_refused("voxel_size = @\"0 m\"", "voxel_size: found \"0 m\", " + length + ", greater than 0 m");
  check_key_refused("cluster_time = @\"-2 s\"",
                    "cluster_time: found \"-2 s\", " + time + ", greater than 0 s");
  check_key_refused("rest_time = @\"0 s\"", "rest_time: found \"0 s\", " + time + ", greater than 0 s");
  check_key_refused("rest_time = @\"3 m\"",
                    "rest_time: found \"3 m\", " + time + " (\"m\" is no unit of that dimension)");
  check_key_refused(
      "thickness = @\"layers\"",
      "thickness: found \"layers\", expected one of layer, equidimensional; did you mean \"layer\"?");
  check_key_refused("maximum_records = @0", "maximum_records: found 0, expected a whole number at least 1");
  check_key_refused("voxel_events = @0", "voxel_events: found 0, expected a whole number at least 1");
}

TEST_CASE("a place on Earth needs a valid latitude, longitude, depth and time",
          "[common][case][seismicity]") {
  check_place_refused("\"-56.7 degree\"", "@\"90 degree\"",
                      "latitude: found \"90 degree\", expected an angle with its unit such as \"56.7 "
                      "degree\", greater than -90 degree and "
                      "less than 90 degree");
  check_place_refused(
      "\"-56.7 degree\"", "@\"56.7\"",
      "latitude: found \"56.7\", expected an angle with its unit such as \"56.7 degree\" (the "
      "unit is missing)");
  check_place_refused("\"123.456789 deg\"", "@\"181 deg\"",
                      "longitude: found \"181 deg\", expected an angle with its unit such as \"56.7 "
                      "degree\", at least -180 degree and at "
                      "most 180 degree");
  check_place_refused(
      "\"2.5 km\"", "@\"2.5 s\"",
      "depth: found \"2.5 s\", expected a length with its unit such as \"0.25 m\" (\"s\" is no "
      "unit of that dimension)");
  check_place_refused("azimuth = \"30 degree\"", "azimuth = @\"1 percent\"",
                      "azimuth: found \"1 percent\", expected an angle with its unit such as \"40 degree\" "
                      "(\"percent\" is no unit of that dimension)");
  check_place_refused(
      "azimuth = \"30 degree\"", "azimuth = @\"30 degree\"\nsection_azimuth = \"30 degree\"",
      "azimuth: found \"30 degree\", expected no such key with section_azimuth: the y axis of a "
      "section points up");
  const std::string time = "a time in UTC such as \"2026-01-31T12:00:00Z\"";
  for (const char* start : {"2026-02-29T12:00:00Z", "2026-01-31T24:00:00Z", "2026-01-31 12:00:00Z",
                            "2026-01-31T12:00:00", "2026-01-31T12:00:00+01:00", "2026-1-31T12:00:00Z",
                            "2026-01-31T12:00:00.Z", "2026-13-01T12:00:00Z", "2026-01-31T12:60:00Z", "now"})
    check_place_refused("\"2026-01-31T12:00:00.25Z\"", fmt::format("@\"{}\"", start),
                        fmt::format("start: found \"{}\", expected {}", start, time));
  CHECK(reading_of(replaced(place, "2026-01-31T12:00:00.25Z", "2028-02-29T23:59:59Z")).value.georeference);
}

TEST_CASE("a place on Earth that is not complete is refused key by key", "[common][case][seismicity]") {
  const std::vector<std::string> faults = faults_of(valid_case + "[georeference]\n");
  REQUIRE(faults.size() == 4);
  const char* const keys[]{"latitude", "longitude", "depth", "start"};
  for (std::size_t i = 0; i < faults.size(); ++i)
    CHECK_THAT(faults[i], Catch::Contains(fmt::format("georeference.{}: found nothing", keys[i])));
}

TEST_CASE("clusters smaller than the elements and rates with a wrong prefix are warned of",
          "[common][case][seismicity]") {
  CHECK(reading_of(seismic).warnings.empty());
  const FaultList narrow = reading_of(replaced(seismic, "3 m\"", "3 cm\"")).warnings;
  REQUIRE(narrow.size() == 1);
  CHECK(narrow[0].key == "seismicity.cluster_radius");
  CHECK(narrow[0].found == "0.03 m");
  CHECK_THAT(narrow[0].expected, Catch::Contains("at least mesh.fracture_size, 0.25 m"));
  const FaultList fast = reading_of(replaced(seismic, "2 mm/s", "2 km/s")).warnings;
  REQUIRE(fast.size() == 1);
  CHECK(fast[0].key == "seismicity.slip_rate");
}
