// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include "tests/common/case_fixture.hpp"

using namespace fissura;
using namespace fissura::test;

using Lines = std::vector<std::string>;

namespace {

Case read(const std::string& text, const std::vector<std::string>& overrides) {
  const Folder folder;
  folder.write("case.toml", text);
  return read_case({folder.path(), {}, overrides}).value;
}

Lines faults_with(const std::vector<std::string>& overrides) {
  const Folder folder;
  folder.write("case.toml", valid_case);
  return faults_in(folder, overrides);
}

const std::vector<std::string> shear_failure{"failure.cohesion=10 MPa", "failure.friction_angle=30 degree"};

std::vector<std::string> with_shear_failure(const std::string& assignment) {
  std::vector<std::string> overrides = shear_failure;
  overrides.push_back(assignment);
  return overrides;
}

/// The valid case without anything that is pumped or broken.
std::string dry_case() {
  std::string text = valid_case;
  const std::size_t begin = text.find("[[fracture]]");
  return text.erase(begin, text.find("[output]") - begin);
}

}  // namespace

TEST_CASE(
    "a case that says nothing of growth has elastic rock, prescribed paths and tips as fine as its fractures",
    "[common][case][growth]") {
  const Case value = read(valid_case, {});
  CHECK_FALSE(value.bulk_failure.active);
  CHECK(value.growth.path == PathRule::prescribed);
  CHECK(value.growth.tip == TipRule::insertion);
  CHECK(value.mesh.tip_size == 0.25);
  CHECK(value.mesh.tip_radius == 1.0);
  CHECK(value.mesh.tip_gradation == 0.4);
  CHECK_FALSE(value.mesh.lattice_angle.has_value());
  CHECK(value.rock.friction_coefficient == 0.6);
}

TEST_CASE("growth and failure are read in SI, and --set takes their words without quotes",
          "[common][case][growth]") {
  const Case value = read(
      valid_case,
      {"growth.path=free", "growth.turn_limit=60 degree", "growth.nucleation=true", "mesh.tip_size=0.2 m",
       "mesh.lattice_angle=30 degree", "rock.friction_coefficient=0.3", "failure.softening=linear",
       "failure.cohesion=10 MPa", "failure.friction_angle=30 degree", "failure.dilation_angle=10 degree"});
  CHECK(value.growth.path == PathRule::free);
  CHECK(value.growth.turn_limit == Approx(std::numbers::pi / 3));
  CHECK(value.growth.nucleation);
  CHECK(value.mesh.tip_radius == 4 * 0.2);
  CHECK(*value.mesh.lattice_angle == Approx(std::numbers::pi / 6));
  CHECK(value.rock.friction_coefficient == 0.3);
  CHECK(value.bulk_failure.active);
  CHECK(value.bulk_failure.softening == Softening::linear);
  CHECK(value.bulk_failure.cohesion == 10e6);
  CHECK(value.bulk_failure.dilation_angle == Approx(std::numbers::pi / 18));
}

TEST_CASE("a table [failure] without keys lets rock fail in tension", "[common][case][growth]") {
  const Case value = read(valid_case + "[failure]\n", {});
  CHECK(value.bulk_failure.active);
  CHECK(value.bulk_failure.cohesion == 0);
  CHECK(value.bulk_failure.softening == Softening::exponential);
}

TEST_CASE("the azimuth of the bedding counts from north clockwise, its angle from x counter-clockwise",
          "[common][case][growth]") {
  const auto angle = [](const std::string& azimuth) {
    return read(valid_case,
                {"failure.strength_across_bedding=0.5 MPa", "failure.bedding_azimuth=" + azimuth + " degree"})
        .bulk_failure.bedding_angle;
  };
  CHECK(angle("90") == Approx(0).margin(1e-15));
  CHECK(angle("0") == Approx(std::numbers::pi / 2));
  CHECK(angle("40") == Approx(50 * std::numbers::pi / 180));
}

TEST_CASE("a case without injection, fluid and fractures is dry", "[common][case][growth]") {
  const Case value = read(dry_case(), {});
  CHECK(value.injection.perforations.empty());
  CHECK(value.injection.stages.empty());
  CHECK(value.fluids.empty());
  CHECK(value.fractures.empty());
}

TEST_CASE("malformed growth: a rule that starts from failed rock without failure, or along a given path",
          "[common][case][growth][malformed]") {
  const std::string failure = "a table [failure] beside it: fractures begin here where the rock has failed";
  CHECK(faults_with({"growth.path=free", "growth.tip=damage"}) ==
        Lines{"--set: growth.tip: found \"damage\", expected " + failure});
  CHECK(faults_with({"growth.path=free", "growth.nucleation=true"}) ==
        Lines{"--set: growth.nucleation: found true, expected " + failure});
  CHECK(faults_with(with_shear_failure("growth.tip=damage")) ==
        Lines{"--set: growth.tip: found \"damage\", expected growth.path = \"free\" beside it"});
  CHECK(faults_with(with_shear_failure("growth.nucleation=true")) ==
        Lines{"--set: growth.nucleation: found true, expected growth.path = \"free\" beside it"});
}

TEST_CASE("malformed growth: words, ranges and spelling", "[common][case][growth][malformed]") {
  CHECK(faults_with({"growth.path=fre"}) ==
        Lines{"--set: growth.path: found \"fre\", expected one of prescribed, free; did you mean \"free\"?"});
  CHECK(faults_with({"growth.trigger=0"}) ==
        Lines{"--set: growth.trigger: found 0, expected a number greater than 0"});
  CHECK(faults_with({"growth.failure_damage=1.5"}) ==
        Lines{"--set: growth.failure_damage: found 1.5, expected a number greater than 0 and at most 1"});
  CHECK_THAT(faults_with({"growth.turn_limit=120 degree"}).at(0),
             Catch::Contains("growth.turn_limit: found \"120 degree\", expected an angle"));
  CHECK_THAT(faults_with({"growth.trigerr=0.5"}).at(0), Catch::Contains("did you mean \"trigger\"?"));
}

TEST_CASE("malformed failure: a surface that cannot be", "[common][case][growth][malformed]") {
  CHECK(
      faults_with(with_shear_failure("failure.dilation_angle=31 degree")) ==
      Lines{"--set: failure.dilation_angle: found \"31 degree\", expected at most friction_angle: more would "
            "make energy out of sliding"});
  CHECK(faults_with({"failure.friction_angle=30 degree"}) ==
        Lines{"--set: failure.friction_angle: found \"30 degree\", expected no such key without cohesion: "
              "the rock "
              "then fails in tension only"});
  CHECK(faults_with({"failure.cohesion=10 MPa"}) ==
        Lines{"--set: failure.friction_angle: found nothing, expected an angle with its unit such as \"40 "
              "degree\", "
              "at least 0 radian and less than 1.5707963267948966 radian"});
  SECTION("in situ, s_1 - s_3 = 20 - 10 MPa but 2 c cos(phi) + 30 MPa sin(phi) = 2 x 1 x 0.996 + 2.61")
  CHECK_THAT(
      faults_with({"failure.cohesion=1 MPa", "failure.friction_angle=5 degree"}).at(0),
      Catch::Contains("failure.cohesion: found an in-situ difference of principal stresses of 1e+07 Pa") &&
          Catch::Contains("4.60706e+06 Pa: the rock would fail before the run begins"));
  SECTION("an apex of 0.6 / tan(40 degree) = 0.715 MPa below the tensile strength of 1 MPa")
  CHECK_THAT(faults_with({"failure.cohesion=0.6 MPa", "failure.friction_angle=40 degree"}).at(0),
             Catch::Contains("more than rock.tensile_strength tan(friction_angle), 839100 Pa"));
  SECTION("half of the bedding")
  CHECK(faults_with({"failure.bedding_azimuth=20 degree"}) ==
        Lines{"--set: failure.strength_across_bedding: found nothing, expected strength_across_bedding and "
              "bedding_azimuth, or neither"});
}

TEST_CASE("malformed mesh: tips and refinements of sizes that do not fit",
          "[common][case][growth][malformed]") {
  CHECK(faults_with({"mesh.tip_size=0.3 m"}) ==
        Lines{"--set: mesh.tip_size: found 0.3 m, expected at most mesh.fracture_size, 0.25 m"});
  CHECK(faults_with({"mesh.tip_radius=0.1 m"}) ==
        Lines{"--set: mesh.tip_radius: found 0.1 m, expected at least mesh.tip_size, 0.25 m"});
  const std::string rectangle = "[[mesh.refinement]]\nsize = \"1 m\"\nwest = \"0 m\"\nsouth = \"0 m\"\n";
  check_addition_refused(rectangle + "east = @\"-1 m\"\nnorth = \"1 m\"\n",
                         "mesh.refinement[0].east: found -1 m, expected east of west, 0 m");
  check_addition_refused(rectangle + "east = \"1 m\"\nnorth = @\"0 m\"\n",
                         "mesh.refinement[0].north: found 0 m, expected north of south, 0 m");
  check_addition_refused(
      "@[[mesh.refinement]]\nsize = \"1 m\"\nwest = \"300 m\"\neast = \"310 m\"\n"
      "south = \"0 m\"\nnorth = \"1 m\"\n",
      "mesh.refinement[0]: found x from 300 to 310 m, y from 0 to 1 m, expected a rectangle that "
      "overlaps the domain, |x| < 200 m and |y| < 150 m");
  check_addition_refused(
      "[[mesh.refinement]]\nsize = @\"50 m\"\nwest = \"0 m\"\neast = \"1 m\"\n"
      "south = \"0 m\"\nnorth = \"1 m\"\n",
      "mesh.refinement[0].size: found 50 m, expected at most mesh.far_size, 40 m");
}
