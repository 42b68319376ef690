// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/common/case_fixture.hpp"

using namespace fissura;
using namespace fissura::test;

using Lines = std::vector<std::string>;

TEST_CASE("malformed case 21: a schedule that does not go forward", "[common][case][malformed]") {
  check_refused(
      "begin = \"6 s\"", "begin = @\"0 s\"",
      "injection.stage[1].begin: found 0 s, expected later than the stage before, which begins at 0 s");
}

TEST_CASE("malformed case 22: a schedule with a gap or an overlap", "[common][case][malformed]") {
  SECTION("nothing is said of the time before the first stage")
  check_refused(
      "begin = \"0 s\"", "begin = @\"1 s\"",
      "injection.stage[0].begin: found 1 s, expected 0 s for the first stage: the schedule has a gap before "
      "it (a first stage may be shut_in = true)");
  SECTION("a ramp that the next stage cuts off")
  check_refused(
      "begin = \"0 s\"", "begin = \"0 s\"\nramp = @\"7 s\"",
      "injection.stage[0].ramp: found 7 s, expected at most the 6 s until the next stage or the end of the "
      "run, which it would overlap");
}

TEST_CASE("malformed case 23: a rate without a fluid", "[common][case][malformed]") {
  check_refused("[[injection.stage]]\nbegin = \"0 s\"\nrate = \"1e-3 m^3/s\"\nfluid = \"slickwater\"\n",
                "@[[injection.stage]]\nbegin = \"0 s\"\nrate = \"1e-3 m^3/s\"\n",
                "injection.stage[0].fluid: found nothing, expected a text");
}

TEST_CASE("malformed case 23: a stage that says twice, or not at all, what is held",
          "[common][case][malformed]") {
  SECTION("twice")
  check_refused(
      "rate = \"1e-3 m^3/s\"", "rate = @\"1e-3 m^3/s\"\npressure = \"6 MPa\"",
      "injection.stage[0].rate: found rate, pressure, expected exactly one of rate, pressure and shut_in = "
      "true");
  SECTION("not at all")
  check_refused(
      "[[injection.stage]]\nbegin = \"6 s\"\nshut_in = true", "@[[injection.stage]]\nbegin = \"6 s\"",
      "injection.stage[1].rate: found none of them, expected exactly one of rate, pressure and shut_in = "
      "true");
}

TEST_CASE("malformed case 24: the run ends before it begins, or before a stage",
          "[common][case][malformed]") {
  SECTION("before it begins")
  check_refused(
      "end = \"10 s\"", "end = @\"-10 s\"",
      "time.end: found \"-10 s\", expected a time with its unit such as \"10 s\", greater than 0 s");
  SECTION("before a stage")
  check_refused(
      "begin = \"6 s\"", "begin = @\"10 s\"",
      "injection.stage[1].begin: found 10 s, expected earlier than the end of the run, time.end = 10 s");
}

TEST_CASE("malformed case 25: a coupling interval that fits neither the structure nor the schedule",
          "[common][case][malformed]") {
  SECTION("shorter than an explicit step: half of 0.25 m at 3771 m/s")
  check_addition_refused(
      "[coupling]\nmaximum_interval = @\"30 us\"\n",
      "coupling.maximum_interval: found 3e-05 s, expected at least an explicit step of the "
      "structure, about 3.31456e-05 s");
  SECTION("longer than a stage")
  check_addition_refused(
      "[coupling]\nmaximum_interval = @\"5 s\"\n",
      "coupling.maximum_interval: found 5 s, expected at most the duration of every stage; "
      "injection.stage[1] lasts 4 s");
  SECTION("limits of its number of steps the wrong way round")
  check_addition_refused("[coupling]\nminimum_steps = @30\n",
                         "coupling.minimum_steps: found 30, expected at most maximum_steps, 20");
  SECTION("output less often than once")
  check_refused("interval = \"0.5 s\"", "interval = @\"11 s\"",
                "output.interval: found 11 s, expected at most the run, time.end = 10 s");
}

TEST_CASE("malformed case 27: lines and sizes that leave no area", "[common][case][malformed]") {
  SECTION("a domain without width")
  check_refused(
      "width = \"400 m\"", "width = @\"0 m\"",
      "domain.width: found \"0 m\", expected a length with its unit such as \"0.25 m\", greater than 0 m");
  SECTION("two lines on one another")
  check_refused(
      "[[\"1 m\", \"0 m\"], [\"16 m\", \"0 m\"]]", "@[[\"0.5 m\", \"0 m\"], [\"16 m\", \"0 m\"]]",
      "fracture[1].points: found a line on top of fracture \"slit\", expected lines that share single points "
      "at most: no area lies between these");
  SECTION("elements larger than the domain")
  check_refused(
      "far_size = \"40 m\"", "far_size = @\"301 m\"",
      "mesh.far_size: found 301 m, expected at most the smaller side of the domain, 300 m: no element would "
      "have an area inside it");
}

TEST_CASE("malformed case 28: a stage names a fluid that is not there", "[common][case][malformed]") {
  check_refused(
      "fluid = \"slickwater\"", "fluid = @\"slikwater\"",
      "injection.stage[0].fluid: found \"slikwater\", expected the name of a [[fluid]]: slickwater; did you "
      "mean \"slickwater\"?");
}

TEST_CASE("malformed case 29: a point, or a name, given twice", "[common][case][malformed]") {
  SECTION("a point of a line")
  check_refused("[[\"1 m\", \"0 m\"], [\"16 m\", \"0 m\"]]",
                "[[\"1 m\", \"0 m\"], [\"16 m\", \"0 m\"], @[\"16 m\", \"0 m\"]]",
                "fracture[1].points[2]: found (16, 0) m once more, expected every point of a line once: a "
                "piece of line "
                "needs a length");
  SECTION("the name of a fracture")
  check_refused("name = \"east wing\"", "name = @\"slit\"",
                "fracture[1].name: found \"slit\", expected a name that no other fracture has");
}

TEST_CASE("malformed case 30: a body that nothing holds", "[common][case][malformed]") {
  const std::string traction = "{ kind = \"traction\" }", roller = "{ kind = \"roller\" }";
  SECTION("in x: rollers at south and north let it slide east") {
    check_addition_refused(
        fmt::format("@[boundary]\nwest = {}\neast = {}\nsouth = {}\nnorth = {}\n", traction, traction, roller,
                    roller),
        "boundary: found nothing that holds the body in x, expected a fixed or displacement side, or "
        "a roller at west or east");
  }
  SECTION("in y")
  check_addition_refused(
      fmt::format("@[boundary]\nwest = {}\neast = {}\nsouth = {}\nnorth = {}\n", roller, traction, traction,
                  traction),
      "boundary: found nothing that holds the body in y, expected a fixed or displacement side, or a "
      "roller at south or north");
  SECTION("two rollers at a corner are enough") {
    CHECK(faults_of(valid_case + fmt::format("[boundary]\nwest = {}\neast = {}\nsouth = {}\nnorth = {}\n",
                                             roller, traction, roller, traction)) == Lines{});
  }
}

TEST_CASE("malformed case 31: a fracture outside the domain, across its border, or without length",
          "[common][case][malformed]") {
  const std::string wing = "[[\"1 m\", \"0 m\"], [\"16 m\", \"0 m\"]]";
  SECTION("outside") {
    CHECK(faults_of(replaced(valid_case, wing, "[[\"201 m\", \"0 m\"], [\"216 m\", \"0 m\"]]")) ==
          Lines{"case.toml:41:11: fracture[1].points[0]: found (201, 0) m, expected a point inside the "
                "domain, |x| < "
                "200 m and |y| < 150 m",
                "case.toml:41:29: fracture[1].points[1]: found (216, 0) m, expected a point inside the "
                "domain, |x| < "
                "200 m and |y| < 150 m"});
  }
  SECTION("across the border, or ending on it")
  check_refused(wing, "[[\"1 m\", \"0 m\"], @[\"200 m\", \"0 m\"]]",
                "fracture[1].points[1]: found (200, 0) m, expected a point inside the domain, |x| < 200 m "
                "and |y| < 150 "
                "m");
  SECTION("too short for an element")
  check_refused(wing, "@[[\"1 m\", \"0 m\"], [\"1.1 m\", \"0 m\"]]",
                "fracture[1].points: found a line of 0.1 m, expected at least one element, "
                "mesh.fracture_size = 0.25 m");
  SECTION("a single point")
  check_refused(
      wing, "@[[\"1 m\", \"0 m\"]]",
      "fracture[1].points: found an array, expected at least two points such as [[\"-1 m\", \"0 m\"], [\"1 "
      "m\", \"0 m\"]]");
}

TEST_CASE("malformed case 33: a perforation that is on no open fracture", "[common][case][malformed]") {
  SECTION("beside it")
  check_refused(
      "position = [\"0 m\", \"0 m\"]", "position = @[\"0 m\", \"1 cm\"]",
      "injection.perforation[0].position: found (0, 0.01) m, expected a point on an open fracture; the "
      "nearest, \"slit\", is 0.01 m away");
  SECTION("on rock that is still intact")
  check_refused(
      "position = [\"0 m\", \"0 m\"]", "position = @[\"5 m\", \"0 m\"]",
      "injection.perforation[0].position: found (5, 0) m, expected a point on an open fracture; the nearest, "
      "\"slit\", is 4 m away");
}

TEST_CASE("malformed case 33: a case without an open fracture has nowhere to inject",
          "[common][case][malformed]") {
  CHECK(
      faults_of(replaced(valid_case, "kind = \"open\"", "kind = \"intact\"")) ==
      Lines{"case.toml:53:12: injection.perforation[0].position: found (0, 0) m, expected a point on an open "
            "fracture; the case has none"});
}

TEST_CASE("malformed case 34: an in-situ state that could not have been there before the run",
          "[common][case][malformed]") {
  SECTION("weight that no stress carries")
  check_refused(
      "pore_pressure = \"30 MPa\"",
      "pore_pressure = \"30 MPa\"\nbody_acceleration = [\"0 m/s^2\", \"-9.81 m/s^2\"]\n\n@[in_situ.gradient]",
      "in_situ.gradient: found forces that do not balance in y: -24525 Pa/m remain, expected div(stress) - "
      "biot_coefficient grad(pore_pressure) + density body_acceleration = 0 (tension positive)");
  SECTION("tension beyond the strength of the rock") {
    const std::string text = replaced(valid_case, "minimum_horizontal_stress = \"10 MPa\"",
                                      "minimum_horizontal_stress = \"-2 MPa\"");
    CHECK(faults_of(text) ==
          Lines{"case.toml:27:29: in_situ: found an effective tension of 2e+06 Pa at (-200, -150) "
                "m, expected at most rock.tensile_strength, 1000000 Pa"});
  }
  SECTION(
      "weight carried by stress and pore pressure is in equilibrium: 2500 x 9.81 = 24525 = 14715 + 9810") {
    CHECK(
        faults_of(replaced(valid_case, "pore_pressure = \"30 MPa\"",
                           "pore_pressure = \"30 MPa\"\nbody_acceleration = [\"0 m/s^2\", \"-9.81 m/s^2\"]\n"
                           "[in_situ.gradient]\nstress_yy = [\"0 Pa/m\", \"-14715 Pa/m\"]\n"
                           "pore_pressure = [\"0 Pa/m\", \"-9810 Pa/m\"]")) == Lines{});
  }
}

TEST_CASE("malformed case 35: principal stresses out of order, or of the other sign",
          "[common][case][malformed]") {
  SECTION("no sign")
  check_refused("[in_situ]\nsign = \"compression_positive\"\n", "@[in_situ]\n",
                "in_situ.sign: found nothing, expected one of compression_positive, tension_positive");
  SECTION("out of order")
  check_refused(
      "maximum_horizontal_stress = \"15 MPa\"", "maximum_horizontal_stress = @\"9 MPa\"",
      "in_situ.maximum_horizontal_stress: found \"9 MPa\", expected at least as much compression as "
      "minimum_horizontal_stress; compression counts by in_situ.sign");
  SECTION("the other sign") {
    const Lines faults = faults_of(replaced(valid_case, "compression_positive", "tension_positive"));
    REQUIRE(faults.size() == 2);
    CHECK_THAT(faults[1], Catch::Contains("is in_situ.sign the other one?"));
    CHECK_THAT(faults[0], Catch::Contains("at least as much compression as minimum_horizontal_stress"));
  }
}
