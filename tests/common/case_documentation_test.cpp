// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <iterator>

#include "common/case/expected.hpp"
#include "tests/common/case_fixture.hpp"

using namespace fissura;
using namespace fissura::test;

namespace {

std::string manual() {
  std::ifstream stream(FISSURA_SOURCE_DIR "/docs/case_format.md");
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The keys of a table, from what is said when it has one that nobody knows.
std::vector<std::string> keys_in(const std::string& fault) {
  const std::string lead = "expected one of ";
  REQUIRE_THAT(fault, Catch::Contains("found an unknown key") && Catch::Contains(lead));
  const std::size_t begin = fault.find(lead) + lead.size();
  std::string names = fault.substr(begin, fault.find(';', begin) - begin);
  std::vector<std::string> keys;
  for (std::size_t comma = names.find(", "); comma != std::string::npos; comma = names.find(", ")) {
    keys.push_back(names.substr(0, comma));
    names.erase(0, comma + 2);
  }
  keys.push_back(names);
  return keys;
}

const std::string optional_tables = R"(
[failure]
cohesion = "10 MPa"
friction_angle = "30 degree"
strength_across_bedding = "0.5 MPa"
bedding_azimuth = "20 degree"
[natural_fractures]
friction_coefficient = 0.6
[[natural_fractures.set]]
name = "joints"
orientation = "90 deg"
spacing = "80 m"
length = "40 m"
persistence = "80 m"
[[natural_fractures.trace]]
name = "fault"
centre = ["30 m", "30 m"]
azimuth = "0 deg"
length = "20 m"
[[mesh.refinement]]
size = "1 m"
west = "0 m"
east = "10 m"
south = "0 m"
north = "10 m"
[[output.probe]]
name = "beside"
position = ["0 m", "1 m"]
[georeference]
latitude = "56.7 degree"
longitude = "-3 degree"
depth = "2 km"
start = "2026-01-31T12:00:00Z"
[[initial_velocity]]
velocity = ["1 m/s", "0 m/s"]
west = "0 m"
east = "10 m"
south = "0 m"
north = "10 m"
)";

}  // namespace

TEST_CASE("every key of every table stands in docs/case_format.md", "[common][case]") {
  const std::string text = manual();
  REQUIRE_FALSE(text.empty());
  const std::string table = GENERATE(
      "", "time.", "domain.", "mesh.", "mesh.refinement[0].", "rock.", "failure.", "growth.", "in_situ.",
      "in_situ.gradient.", "boundary.", "fracture[0].", "fracture[1].", "natural_fractures.",
      "natural_fractures.set[0].", "natural_fractures.trace[0].", "fluid[0].", "leak_off.", "injection.",
      "injection.perforation[0].", "injection.stage[0].", "coupling.", "dynamics.", "network.", "output.",
      "output.probe[0].", "initial_velocity[0].", "seismicity.", "georeference.",
      "deadlines.", "checkpoint.", "pressure_range.", "exchange.", "participants.");
  const Folder folder;
  folder.write("case.toml", valid_case + optional_tables);
  const std::vector<std::string> faults = faults_in(folder, {table + "qqq=1"});
  REQUIRE(faults.size() == 1);
  for (const std::string& key : keys_in(faults.front())) {
    bool documented = false;
    for (const char* const form : {"`{}`", "`.{}`", "[{}]", ".{}]"})
      documented = documented || text.find(fmt::format(fmt::runtime(form), key)) != std::string::npos;
    INFO("key " << key << " of table " << table);
    CHECK(documented);
  }
}

TEST_CASE("every measure stands in docs/case_format.md", "[common][case][expected]") {
  const std::string text = manual();
  for (const Measure measure : {Measure::mean_relative_error, Measure::value_at, Measure::mean,
                                Measure::maximum, Measure::minimum, Measure::time_when_below})
    CHECK_THAT(text, Catch::Contains(fmt::format("`{}`", name(measure))));
}
