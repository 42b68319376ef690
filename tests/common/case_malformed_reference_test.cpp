// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/common/case_fixture.hpp"

using namespace fissura;
using namespace fissura::test;

using Lines = std::vector<std::string>;

namespace {

const std::string points_of_wing = "points = [[\"1 m\", \"0 m\"], [\"16 m\", \"0 m\"]]";

}  // namespace

TEST_CASE("malformed case 26: a file of points that is not there, or holds no points",
          "[common][case][malformed]") {
  const Folder folder;
  folder.write("case.toml", replaced(valid_case, points_of_wing, "file = \"wing.csv\""));
  SECTION("not there") {
    const Lines faults = faults_in(folder);
    REQUIRE(faults.size() == 1);
    CHECK_THAT(faults[0], Catch::StartsWith(
                              "case.toml:41:8: fracture[1].file: found \"wing.csv\", expected a file of the "
                              "case folder; there is no file /"));
  }
  SECTION("no points in it") {
    folder.write("wing.csv", "# x,y\n1,0\n16;0\n");
    const Lines faults = faults_in(folder);
    REQUIRE(faults.size() == 1);
    CHECK_THAT(faults[0], Catch::Contains("expected x,y in metres on every line; /"));
    CHECK_THAT(faults[0], Catch::EndsWith("wing.csv:3 has \"16;0\""));
  }
  SECTION("a good one") {
    folder.write("wing.csv", "# x,y\n1,0\n16, 0\r\n");
    CHECK(faults_in(folder) == Lines{});
  }
}

TEST_CASE("malformed case 32: natural fractures without a spacing, with a bare number, without friction",
          "[common][case][malformed]") {
  SECTION("every fault of a set at once")
  CHECK(faults_of(valid_case + R"([[natural_fractures.set]]
name = "joints"
orientation = "90 deg"
spacing = "0 m"
length = "40 m"
persistence = 1.5
persistence_reading = "spacing"
east = "300 m"
)") == Lines{"case.toml:67:1: natural_fractures.set[0].friction_coefficient: found nothing, expected a "
             "number at least 0",
             "case.toml:70:11: natural_fractures.set[0].spacing: found \"0 m\", expected a length with its "
             "unit such as "
             "\"0.25 m\", greater than 0 m",
             "case.toml:72:15: natural_fractures.set[0].persistence: found 1.5, expected a length with its "
             "unit such as "
             "\"0.25 m\", greater than 0 m",
             "case.toml:73:23: natural_fractures.set[0].persistence_reading: found \"spacing\", expected one "
             "of repeat, gap",
             "case.toml:74:8: natural_fractures.set[0].east: found \"300 m\", expected a length with its "
             "unit such as "
             "\"0.25 m\", at least -200 m and at most 200 m"});
  SECTION("a trace given twice over, of a name that is taken")
  CHECK(faults_of(valid_case + R"([natural_fractures]
friction_coefficient = 0.6
dilation_angle = "40 deg"
dilation_slip = "1 mm"
[[natural_fractures.trace]]
name = "slit"
points = [["0 m", "20 m"], ["10 m", "20 m"]]
length = "10 m"
)") == Lines{"case.toml:69:18: natural_fractures.dilation_angle: found 40 degree, expected at most the angle "
             "of friction: "
             "more would make energy out of sliding",
             "case.toml:72:8: natural_fractures.trace[0].name: found \"slit\", expected a name that no other "
             "fracture "
             "and no other set has",
             "case.toml:74:10: natural_fractures.trace[0].length: found \"10 m\", expected either points, or "
             "centre, "
             "azimuth and length"});
  SECTION("more traces than anybody could mean")
  CHECK(faults_of(valid_case + R"([[natural_fractures.set]]
friction_coefficient = 0.6
name = "joints"
orientation = "90 deg"
spacing = "8 mm"
length = "40 m"
persistence = "80 m"
)") == Lines{"case.toml:71:11: natural_fractures.set[0].spacing: found about 187500 traces, expected at most "
             "20000 in the "
             "region, by spacing and persistence"});
}

TEST_CASE("malformed case 32: a file of traces with a line of three numbers, or without any trace",
          "[common][case][malformed]") {
  const Folder folder;
  folder.write("case.toml",
               valid_case + "[natural_fractures]\nfriction_coefficient = 0.6\nfile = \"joints.csv\"\n");
  SECTION("three numbers") {
    folder.write("joints.csv", "# x1,y1,x2,y2\n0,20,10,20\n0,40,10\n");
    const Lines faults = faults_in(folder);
    REQUIRE(faults.size() == 1);
    CHECK_THAT(
        faults[0],
        Catch::StartsWith(
            "case.toml:69:8: natural_fractures.file: found \"joints.csv\", expected x1,y1,x2,y2 in metres"));
    CHECK_THAT(faults[0], Catch::EndsWith("joints.csv:3 has \"0,40,10\""));
  }
  SECTION("none") {
    folder.write("joints.csv", "# x1,y1,x2,y2\n");
    const Lines faults = faults_in(folder);
    REQUIRE(faults.size() == 1);
    CHECK_THAT(faults[0], Catch::Contains("expected at least one trace"));
  }
}

TEST_CASE("malformed case 36: no file leads out of the case folder, and none includes another",
          "[common][case][malformed]") {
  SECTION("upwards")
  check_refused(
      points_of_wing, "file = @\"../../etc/passwd\"",
      "fracture[1].file: found \"../../etc/passwd\", expected a relative path that stays in the case folder");
  SECTION("by a symbolic link") {
    const Folder folder;
    std::filesystem::create_symlink("/etc/passwd", folder.path() / "wing.csv");
    folder.write("case.toml", replaced(valid_case, points_of_wing, "file = \"wing.csv\""));
    CHECK(faults_in(folder) ==
          Lines{"case.toml:41:8: fracture[1].file: found \"wing.csv\", expected a relative path "
                "that stays in the case folder"});
  }
  SECTION("include") {
    const Lines faults = faults_of("include = \"case.toml\"\n" + valid_case);
    REQUIRE(faults.size() == 1);
    CHECK_THAT(faults[0],
               Catch::StartsWith("case.toml:1:1: include: found an unknown key, expected one of schema,"));
  }
}

TEST_CASE("malformed case 37: an environment variable that is not set", "[common][case][malformed]") {
  ::unsetenv("FISSURA_TEST_MODULUS");
  check_refused("\"32 GPa\"", "@\"${FISSURA_TEST_MODULUS}\"",
                "rock.youngs_modulus: found ${FISSURA_TEST_MODULUS}, expected an environment variable that "
                "is set (it is "
                "not)");
  ::setenv("FISSURA_TEST_MODULUS", "32", 1);
  CHECK(faults_of(replaced(valid_case, "\"32 GPa\"", "\"${FISSURA_TEST_MODULUS} GPa\"")) == Lines{});
  ::unsetenv("FISSURA_TEST_MODULUS");
}

TEST_CASE("malformed case 38: an absolute path", "[common][case][malformed]") {
  check_refused(points_of_wing, "file = @\"/no/such/wing.csv\"",
                "fracture[1].file: found \"/no/such/wing.csv\", expected a relative path that stays in the "
                "case folder");
}

TEST_CASE("malformed case 39: participants cannot be given endpoints of their own, and so not the same one",
          "[common][case][malformed]") {
  CHECK(faults_of(valid_case + "[exchange]\nstructure_endpoint = \"ipc\"\nnetwork_endpoint = \"ipc\"\n") ==
        Lines{"case.toml:68:1: exchange.structure_endpoint: found an unknown key, expected one of endpoint",
              "case.toml:69:1: exchange.network_endpoint: found an unknown key, expected one of endpoint"});
}

TEST_CASE("malformed case 40: a solver that nobody knows", "[common][case][malformed]") {
  check_addition_refused(
      "[participants]\nnetwork = @\"fisura\"\n",
      "participants.network: found \"fisura\", expected one of implicit, fissura, explicit, uniform, "
      "python; did you mean \"fissura\"?");
}

TEST_CASE("malformed case 41: an endpoint that is no address in figures", "[common][case][malformed]") {
  const std::string endpoint =
      GENERATE("tcp://*:5555", "tcp://127.0.0.1.evil.org:1", "tcp://localhost:5555",
               "tcp://192.168.1.256:5555", "tcp://127.0.0.1:65536", "tcp://[::1:5555");
  check_addition_refused("[exchange]\nendpoint = @\"" + endpoint + "\"\n",
                         "exchange.endpoint: found \"" + endpoint +
                             "\", expected \"ipc\" or an address in figures with a port, such as "
                             "\"tcp://127.0.0.1:*\" or \"tcp://192.0.2.7:5555\"");
  const std::string good =
      GENERATE("tcp://127.0.0.1:*", "tcp://[::1]:*", "tcp://192.0.2.7:5555", "tcp://0.0.0.0:5555");
  CHECK(faults_of(valid_case + "[exchange]\nendpoint = \"" + good + "\"\n") == Lines{});
}

TEST_CASE("malformed case 42: reports that are never, or always, due", "[common][case][malformed]") {
  SECTION("every 0 s")
  check_refused(
      "interval = \"0.5 s\"", "interval = @\"0 s\"",
      "output.interval: found \"0 s\", expected a time with its unit such as \"10 s\", greater than "
      "0 s");
  SECTION("after the end")
  check_refused("interval = \"0.5 s\"", "interval = @\"11 s\"",
                "output.interval: found 11 s, expected at most the run, time.end = 10 s");
}

TEST_CASE("malformed case 44: a case of a newer schema is refused without a word on keys it may well have",
          "[common][case][malformed]") {
  check_refused("schema = 1", "schema = @2\nnew_key = 1",
                "schema: found 2, expected 1 (the case needs a newer version of Fissura)");
}
