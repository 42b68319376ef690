// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "common/errors.hpp"
#include "mesh_cases.hpp"
#include "structure/mesh/build_mesh.hpp"
#include "structure/mesh/line_arrangement.hpp"

using namespace fissura;
using namespace fissura::structure;
using Catch::Matchers::Contains;

namespace {

std::string fault_of(const Case& given) {
  try {
    build_mesh(given);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

}  // namespace

TEST_CASE("lines at one degree are refused, naming both and the place", "[structure][mesh][fault]") {
  Case given = single_line();
  add_line(given, "flat", {{-5, 0}, {5, 10 * std::tan(M_PI / 180)}});
  CHECK_THAT(fault_of(given), Contains("'slit'") && Contains("'flat'") && Contains("1 degrees at (-5, 0) m"));
}

TEST_CASE("lines that cross at one degree are refused", "[structure][mesh][fault]") {
  Case given = single_line();
  const double rise = 5 * std::tan(M_PI / 180);
  add_line(given, "flat", {{-4.8, -rise}, {5.2, rise}});
  CHECK_THAT(fault_of(given), Contains("'slit'") && Contains("'flat'"));
}

TEST_CASE("lines on one another are refused, wholly or in part, in either direction",
          "[structure][mesh][fault]") {
  const auto points =
      GENERATE(std::vector<Point>{{-5, 0}, {5, 0}}, std::vector<Point>{{5, 0}, {-5, 0}},
               std::vector<Point>{{-1, 0}, {2, 0}}, std::vector<Point>{{4, 0}, {9, 0}},
               std::vector<Point>{{-9, 0}, {9, 0}}, std::vector<Point>{{3, 4}, {3, 0}, {5, 0}});
  Case given = single_line();
  add_line(given, "twin", points);
  CHECK_THAT(fault_of(given), Contains("'slit'") && Contains("'twin'") && Contains("lie on one another"));
}

TEST_CASE("a line that runs back over itself is refused", "[structure][mesh][fault]") {
  Case given = square(40);
  add_line(given, "folded", {{-5, 0}, {5, 0}, {2, 0}});
  CHECK_THAT(fault_of(given), Contains("'folded'") && Contains("over itself"));
}

TEST_CASE("a stretch without length is refused", "[structure][mesh][fault]") {
  Case given = square(40);
  add_line(given, "dot", {{1, 2}, {1, 2}});
  CHECK_THAT(fault_of(given), Contains("'dot'") && Contains("without length") && Contains("(1, 2) m"));
}

TEST_CASE("a line of one point is refused", "[structure][mesh][fault]") {
  Case given = square(40);
  add_line(given, "dot", {{1, 2}});
  CHECK_THAT(fault_of(given), Contains("'dot'") && Contains("two points"));
}

TEST_CASE("a line outside the domain is refused", "[structure][mesh][fault]") {
  const double wrong = GENERATE(21.0, -1e300, std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity());
  Case given = square(40);
  add_line(given, "far", {{0, 0}, {wrong, 1}});
  CHECK_THAT(fault_of(given), Contains("'far'") && Contains("outside the domain"));
}

TEST_CASE("a line along a side of the domain is refused", "[structure][mesh][fault]") {
  Case given = square(40);
  add_line(given, "edge", {{-3, 20}, {3, 20}});
  CHECK_THAT(fault_of(given), Contains("'edge'") && Contains("side of the domain"));
}

TEST_CASE("lines that pass too near without meeting are refused", "[structure][mesh][fault]") {
  Case given = single_line();
  add_line(given, "above", {{-3, 0.05}, {3, 0.05}});
  CHECK_THAT(fault_of(given), Contains("'slit'") && Contains("'above'") && Contains("within 0.05 m"));
}

TEST_CASE("points of a line that are too near are refused", "[structure][mesh][fault]") {
  Case given = square(40);
  add_line(given, "dense", {{-3, 0}, {0, 0}, {0.05, 0}, {3, 0}});
  CHECK_THAT(fault_of(given), Contains("'dense'") && Contains("0.05 m apart"));
}

TEST_CASE("lines that meet at just more than the smallest angle are meshed", "[structure][mesh][fault]") {
  Case given = single_line();
  const double angle = (smallest_line_angle + 1) * M_PI / 180;
  add_line(given, "flat", {{-5, 0}, {-5 + 6 * std::cos(angle), 6 * std::sin(angle)}});
  const Mesh mesh = build_mesh(given);
  CHECK(area(mesh) == Approx(1600).epsilon(1e-12));
}

TEST_CASE("random lines end in a valid mesh or in a fault of the input", "[structure][mesh][fault]") {
  int meshed = 0;
  for (std::uint64_t seed = 0; seed < 15; ++seed) {
    const Case given = random_lines(seed);
    try {
      const Mesh mesh = build_mesh(given);
      ++meshed;
      REQUIRE(area(mesh) == Approx(400).epsilon(1e-12));
      for (ElementIndex e = 0; e < mesh.elements.size(); ++e) REQUIRE(element_area(mesh, e) > 0);
      for (const ContactUnit& unit : mesh.units) {
        REQUIRE(mesh.position[unit.minus] == mesh.position[unit.plus]);
        REQUIRE(unit.minus != unit.plus);
        REQUIRE(std::hypot(unit.face[0], unit.face[1]) <= unit.length * (1 + 1e-12));
      }
    } catch (const InputError&) {
    }
  }
  CHECK(meshed >= 8);
}
