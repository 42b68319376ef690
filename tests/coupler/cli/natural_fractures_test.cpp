// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include <algorithm>
#include <sstream>

#include "coupler/cli/case_picture.hpp"
#include "coupler/cli/natural_fracture_files.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

CaseReading reading() {
  CaseReading result;
  Case& given = result.value;
  given.title = "a & b";
  given.domain = {200, 100, 1};
  given.mesh.fracture_size = 0.5;
  given.mesh.natural_size = 2;
  given.mesh.far_size = 10;
  given.in_situ.stress = {-10e6, -15e6, 0, -20e6};
  FractureLine slit;
  slit.name = "slit";
  slit.points = {{0, -5}, {0, 5}};
  given.fractures = {slit};
  given.injection.perforations = {{"hole", {0, 0}, 1e-5}};
  NaturalFractureSet set;
  set.name = "joints, \"steep\"";
  set.orientation = {0.1, 0.05};
  set.spacing = {20, 2};
  set.length = {15, 1};
  set.persistence = {30, 3};
  set.west = -100;
  set.east = 100;
  set.south = -50;
  set.north = 50;
  given.natural_fracture_sets = {set};
  result.natural_fractures = add_natural_fractures(given, {});
  return result;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Whether every element that is opened is closed in order, and none has an attribute twice.
bool is_well_formed(const std::string& svg) {
  std::vector<std::string> open;
  for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
    const std::string tag = svg.substr(at + 1, svg.find('>', at) - at - 1);
    std::string name = tag.substr(0, tag.find_first_of(" /", 1));
    if (tag.front() == '/') {
      if (open.empty() || "/" + open.back() != tag) return false;
      open.pop_back();
      continue;
    }
    std::vector<std::string> attributes;
    for (std::size_t equal = tag.find("=\""); equal != std::string::npos; equal = tag.find("=\"", equal + 1))
      attributes.push_back(tag.substr(tag.rfind(' ', equal), equal - tag.rfind(' ', equal)));
    std::sort(attributes.begin(), attributes.end());
    if (std::adjacent_find(attributes.begin(), attributes.end()) != attributes.end()) return false;
    if (tag.back() != '/') open.push_back(name);
  }
  return open.empty();
}

}  // namespace

TEST_CASE("the picture of a case shows every fracture and every change, and is well formed",
          "[coupler][cli]") {
  const CaseReading given = reading();
  REQUIRE(given.natural_fractures.cleaning.size() > 3);
  const std::string svg = case_picture(given);
  CHECK(is_well_formed(svg));
  CHECK(count_of(svg, "<polyline ") == given.value.fractures.size());
  CHECK(count_of(svg, "</title></circle>") == given.natural_fractures.cleaning.size());
  CHECK(count_of(svg, ">a &amp; b</text>") == 1);
  CHECK(count_of(svg, "greatest 15 MPa") == 1);
  CHECK(count_of(svg, "least 10 MPa") == 1);
}

TEST_CASE("the picture without natural fractures is well formed too", "[coupler][cli]") {
  CaseReading given = reading();
  given.value.fractures.resize(1);
  given.natural_fractures = {};
  CHECK(is_well_formed(case_picture(given)));
}

TEST_CASE("the table of traces reads back to the very ends of the traces", "[coupler][cli]") {
  const CaseReading given = reading();
  std::istringstream table(natural_fractures_csv(given.value));
  std::string line;
  std::getline(table, line);
  CHECK(line == "name,set,x1,y1,x2,y2,length,azimuth");
  for (const FractureLine& fracture : given.value.fractures) {
    if (fracture.kind != FractureKind::natural) continue;
    REQUIRE(std::getline(table, line));
    const std::size_t numbers = line.find("\"\"\",\"joints, \"\"steep\"\"\",") == std::string::npos
                                    ? line.rfind("\"\"\",") + 4
                                    : line.find("\"\"\",\"joints, \"\"steep\"\"\",") + 24;
    std::istringstream row(line.substr(numbers));
    for (const Point& point : fracture.points)
      for (const double coordinate : point) {
        std::string cell;
        std::getline(row, cell, ',');
        CHECK(std::stod(cell) == coordinate);
      }
  }
  CHECK_FALSE(std::getline(table, line));
}

TEST_CASE("the report tells every change, in words and in JSON", "[coupler][cli]") {
  const NaturalFractureReport report = reading().natural_fractures;
  const std::vector<std::string> lines = lines_of(report);
  CHECK(lines.size() == 1 + 7 * report.sets.size() + report.cleaning.size());
  const nlohmann::ordered_json json = natural_fractures_json(report);
  CHECK(json["cleaning"].size() == report.cleaning.size());
  CHECK(json["kept"] == report.kept);
  CHECK(json["sets"][0]["expected_intensity"].get<double>() == Approx(15.0 / (20 * 30)));
}
