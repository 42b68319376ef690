// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "tests/common/case_fixture.hpp"

using namespace fissura;
using namespace fissura::test;

namespace {

const std::string natural = R"([natural_fractures]
friction_coefficient = 0.6
file = "joints.csv"
[[natural_fractures.trace]]
name = "fault"
centre = ["50 m", "60 m"]
azimuth = "90 deg"
length = "20 m"
[[natural_fractures.trace]]
name = "vein"
points = [["-80 m", "40 m"], ["-80 m", "70 m"]]
friction_coefficient = 0.3
tensile_strength = "2 MPa"
fracture_energy = "10 N/m"
joint_compliance = "2e-11 m/Pa"
)";

CaseReading reading(const std::vector<std::string>& overrides) {
  const Folder folder;
  folder.write("case.toml", valid_case + natural);
  folder.write("joints.csv", "# x1,y1,x2,y2\n100,-100,130,-70\n-60,-60,-60,-60\n");
  return read_case({folder.path(), {}, overrides});
}

const FractureLine& line_named(const Case& value, const std::string& name) {
  for (const FractureLine& line : value.fractures)
    if (line.name == name) return line;
  FAIL("no line " << name);
  throw;
}

}  // namespace

TEST_CASE("natural fractures of a case: traces and a file share the faces, and may have their own",
          "[common][case][natural]") {
  const CaseReading read = reading({});
  const FractureLine& fault = line_named(read.value, "fault");
  CHECK(fault.kind == FractureKind::natural);
  CHECK(fault.friction_coefficient == 0.6);
  CHECK(fault.residual_aperture == Approx(5e-5));
  CHECK(fault.joint_compliance == Approx(1e-11));
  CHECK(fault.points[0][0] == Approx(40));
  CHECK(fault.points[1][0] == Approx(60));
  CHECK(fault.points[1][1] == Approx(60));
  const FractureLine& vein = line_named(read.value, "vein");
  CHECK(vein.friction_coefficient == 0.3);
  CHECK(vein.residual_aperture == 0);  // cement fills it
  CHECK(vein.joint_compliance == Approx(2e-11));
  const FractureLine& joint = line_named(read.value, "joints 1");
  CHECK(joint.set == "joints");
  CHECK(joint.points == std::vector<Point>{{100, -100}, {130, -70}});
  REQUIRE(read.natural_fractures.cleaning.size() == 1);
  CHECK(read.natural_fractures.cleaning[0].trace == "joints 2");
  CHECK(read.natural_fractures.cleaning[0].cause == "without length");
  CHECK(read.files.size() == 2);
}

TEST_CASE("a single value of a trace can be set from the command line", "[common][case][natural]") {
  const CaseReading read = reading({"natural_fractures.trace[0].azimuth=30 deg", "growth.crossing=never"});
  const FractureLine& fault = line_named(read.value, "fault");
  CHECK(fault.points[1][0] - fault.points[0][0] == Approx(20 * std::sin(std::numbers::pi / 6)));
  CHECK(fault.points[1][1] - fault.points[0][1] == Approx(20 * std::cos(std::numbers::pi / 6)));
  CHECK(read.value.growth.crossing == CrossingRule::never);
}

TEST_CASE("natural fractures that do not hold in situ are a warning, not a fault",
          "[common][case][natural]") {
  const CaseReading read = reading({"natural_fractures.trace[0].friction_coefficient=0.1"});
  REQUIRE(read.warnings.size() == 1 + reading({}).warnings.size());
  CHECK_THAT(describe(read.warnings.back()),
             Catch::Contains("1 natural fracture(s) beyond their frictional strength") &&
                 Catch::Contains("\"fault\""));
}

TEST_CASE("a set is drawn where the case says, by the size of natural fractures", "[common][case][natural]") {
  const Folder folder;
  folder.write("case.toml", valid_case + R"([natural_fractures]
friction_coefficient = 0.8
[[natural_fractures.set]]
name = "east"
orientation = "20 deg"
spacing = "10 m"
length = "12 m"
persistence = "8 m"
persistence_reading = "gap"
west = "50 m"
south = "-100 m"
)");
  const CaseReading read = read_case({folder.path(), {}, {"mesh.natural_size=1 m"}});
  REQUIRE(read.natural_fractures.sets.size() == 1);
  CHECK(read.natural_fractures.drawn > 150);  // 150 m by 250 m with one trace on 10 m by 20 m is 187
  for (const FractureLine& line : read.value.fractures)
    if (line.set == "east")
      for (const Point& point : line.points) CHECK(point[0] >= 49);
  CHECK(read.value.mesh.natural_size == 1);
}
