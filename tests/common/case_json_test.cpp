// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "common/case/case_json.hpp"
#include "tests/common/case_fixture.hpp"

using namespace fissura;
using namespace fissura::test;

namespace {

Case full_case() {
  const Folder folder;
  folder.write("case.toml", valid_case + R"(
[boundary]
east = { kind = "traction", value = ["1 MPa", "-2 MPa"] }
north = { kind = "displacement", value = ["0 m", "1 mm"], ramp = "1 s" }
[coupling]
scheme = "profit2016"
fracture_normal_stiffness = "10 GPa/m"
[failure]
softening = "linear"
cohesion = "10 MPa"
friction_angle = "30 degree"
strength_across_bedding = "0.5 MPa"
bedding_azimuth = "20 degree"
[growth]
path = "free"
tip = "damage"
[seismicity]
thickness = "equidimensional"
cluster_radius = "3 m"
[georeference]
latitude = "56.7 degree"
longitude = "-3 degree"
depth = "2 km"
start = "2026-01-31T12:00:00Z"
section_azimuth = "30 degree"
[[mesh.refinement]]
size = "1 m"
west = "0 m"
east = "10 m"
south = "0 m"
north = "10 m"
)");
  return read_case({folder.path(), {}, {}}).value;
}

}  // namespace

TEST_CASE("a case survives the way to a participant bit by bit", "[common][case][json]") {
  const Case sent = full_case();
  const std::string text = case_to_json(sent).dump();
  const Case received = case_from_json(nlohmann::json::parse(text));
  CHECK(case_to_json(received).dump() == text);
  CHECK(received.in_situ.stress == sent.in_situ.stress);
  CHECK(received.fractures.at(1).points == sent.fractures.at(1).points);
  CHECK(received.fractures.at(1).kind == FractureKind::intact);
  CHECK(received.boundary.north.kind == BoundaryKind::displacement);
  CHECK(received.boundary.east.value == std::array<double, 2>{1e6, -2e6});
  CHECK(received.coupling.scheme == CouplingScheme::profit2016);
  CHECK(received.bulk_failure.softening == Softening::linear);
  CHECK(received.bulk_failure.strength_across_bedding == 0.5e6);
  CHECK_FALSE(received.mesh.lattice_angle.has_value());
  CHECK(received.mesh.refinements.at(0).east == 10);
  CHECK(received.growth.tip == TipRule::damage);
  CHECK(received.injection.stages.at(1).control == StageControl::shut_in);
  CHECK(received.seismicity.thickness == SourceThickness::equidimensional);
  CHECK(received.seismicity.cluster_radius == 3);
  REQUIRE(received.georeference.has_value());
  CHECK(received.georeference->latitude == 56.7);
  CHECK(received.georeference->section_azimuth == sent.georeference->section_azimuth);
}

TEST_CASE("the JSON of a case has the member names of case.hpp as keys and SI numbers",
          "[common][case][json]") {
  const nlohmann::json json = case_to_json(full_case());
  CHECK(json.at("rock").at("youngs_modulus") == 32e9);
  CHECK(json.at("fluids").at(0).at("consistency_index") == 1.67e-3);
  CHECK(json.at("coupling").at("scheme") == "profit2016");
  CHECK(json.at("injection").at("stages").at(0).at("control") == "rate");
}

TEST_CASE("a case with a missing key, a wrong type or an unknown word breaks the protocol",
          "[common][case][json]") {
  nlohmann::json json = case_to_json(full_case());
  SECTION("missing key") {
    json.at("rock").erase("density");
    CHECK_THROWS_WITH(case_from_json(json), Catch::Contains("key 'density' not found"));
  }
  SECTION("wrong type") {
    json.at("time").at("end") = "10 s";
  }
  SECTION("unknown word") {
    json.at("boundary").at("west").at("kind") = "glued";
    CHECK_THROWS_WITH(
        case_from_json(json),
        "the case says \"glued\" where one of fixed, roller, traction, displacement is expected");
  }
  CHECK_THROWS_AS(case_from_json(json), ProtocolError);
}
