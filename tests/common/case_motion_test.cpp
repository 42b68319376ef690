// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/common/case_fixture.hpp"

using namespace fissura;
using namespace fissura::test;

namespace {

const std::string moving = R"(
[[initial_velocity]]
velocity = ["2 m/s", "-0.5 m/s"]
west = "-200 m"
east = "10 m"
south = "0 m"
north = "150 m"
)";

const std::string probed = R"(
[[output.probe]]
name = "ahead"
position = ["11 m", "0 m"]
[[output.probe]]
name = "beside"
position = ["0 m", "150 m"]
)";

const std::string joint = R"(
[[fracture]]
name = "joint"
kind = "natural"
friction_coefficient = 0.1
points = [["-200 m", "20 m"], ["200 m", "20 m"]]
)";

CaseReading reading_of(const std::string& text) {
  const Folder folder;
  folder.write("case.toml", text);
  return read_case({folder.path(), {}, {}});
}

}  // namespace

TEST_CASE("what moves at time 0 and what is observed is read", "[common][case]") {
  const Case value = reading_of(valid_case + moving + probed).value;
  REQUIRE(value.initial_velocities.size() == 1);
  CHECK(value.initial_velocities[0].velocity == std::array<double, 2>{2, -0.5});
  CHECK(value.initial_velocities[0].west == -200);
  CHECK(value.initial_velocities[0].north == 150);
  REQUIRE(value.output.probes.size() == 2);
  CHECK(value.output.probes[0].name == "ahead");
  CHECK(value.output.probes[1].position == Point{0, 150});
  CHECK(value.dynamics.equilibrate);
  CHECK_FALSE(reading_of(valid_case + "\n[dynamics]\nequilibrate = false\ndamping = 0\n"
                                      "initial_mass_scale = 1\nmaximum_mass_scale = 1\n")
                  .value.dynamics.equilibrate);
}

TEST_CASE("probes and moving rectangles lie inside the domain", "[common][case]") {
  check_addition_refused("[[output.probe]]\nname = \"far\"\nposition = @[\"201 m\", \"0 m\"]\n",
                         "output.probe[0].position: found (201, 0) m, expected a point inside the domain, "
                         "|x| <= 200 m and |y| <= "
                         "150 m");
  check_addition_refused(
      "[[output.probe]]\nname = \"here\"\nposition = [\"1 m\", \"0 m\"]\n"
      "[[output.probe]]\nname = @\"here\"\nposition = [\"2 m\", \"0 m\"]\n",
      "output.probe[1].name: found \"here\" once more, expected a name that no other probe has");
  check_addition_refused(
      "[[initial_velocity]]\nvelocity = [\"1 m/s\", \"0 m/s\"]\nwest = \"5 m\"\neast = @\"4 m\"\nsouth = \"0 "
      "m\"\n"
      "north = \"1 m\"\n",
      "initial_velocity[0].east: found 4 m, expected east of west, 5 m");
  check_addition_refused(
      "@[[initial_velocity]]\nvelocity = [\"1 m/s\", \"0 m/s\"]\nwest = \"300 m\"\neast = \"310 m\"\n"
      "south = \"0 m\"\nnorth = \"1 m\"\n",
      "initial_velocity[0]: found x from 300 to 310 m, y from 0 to 1 m, expected a rectangle that overlaps "
      "the "
      "domain, |x| <= 200 m and |y| <= 150 m");
}

TEST_CASE("a natural fracture that does not hold in situ, here from side to side, is warned of",
          "[common][case]") {
  // sigma_n = 12.93 MPa and tau = 2.46 MPa for 15 and 10 MPa turned by 40 degrees; 0.1 sigma_n holds 1.29
  // MPa.
  const FaultList warnings = reading_of(valid_case + joint).warnings;
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0].found, Catch::Contains("\"joint\""));
  CHECK(reading_of(valid_case + replaced(joint, "0.1", "0.6")).warnings.empty());
}
