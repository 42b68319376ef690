// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "common/natural_fractures/natural_network.hpp"
#include "mesh_cases.hpp"
#include "structure/mesh/build_mesh.hpp"
#include "structure/mesh/line_arrangement.hpp"
#include "structure/mesh/mesh_quality.hpp"
#include "structure/mesh/planar_mesh.hpp"

using namespace fissura;
using namespace fissura::structure;

namespace {

constexpr double side = 100, natural = 2;

Case rock() {
  Case given = square(side);
  given.mesh.natural_size = natural;
  given.mesh.far_size = 8;
  given.mesh.tip_size = given.mesh.fracture_size;
  given.mesh.tip_radius = 2;
  given.mesh.tip_gradation = 0.4;
  given.growth.path = PathRule::free;
  return given;
}

FractureLine trace(std::size_t number, Point begin, Point end) {
  FractureLine line;
  line.name = "trace " + std::to_string(number);
  line.kind = FractureKind::natural;
  line.friction_coefficient = 0.6;
  line.points = {begin, end};
  return line;
}

/// A valid mesh has positive areas that fill the square, pairs of coincident nodes and no sliver.
void check_mesh(const Case& given) {
  const Mesh mesh = build_mesh(given);
  CHECK(area(mesh) == Approx(side * side).epsilon(1e-12));
  const MeshQuality quality = measure(mesh);
  // Lines meet at 12 degrees or more; the triangle in a wedge may halve that at worst.
  CHECK(quality.smallest_angle > 6);
  // The stable step hangs on it: cleaning keeps a quarter of an edge between lines.
  CHECK(quality.smallest_altitude > 0.1 * natural);
  for (const ContactUnit& unit : mesh.units) {
    REQUIRE(mesh.position[unit.minus] == mesh.position[unit.plus]);
    REQUIRE(unit.minus != unit.plus);
  }
}

struct Cleaned {
  Case given;
  NaturalFractureReport report;
};

Cleaned cleaned(const std::vector<FractureLine>& traces) {
  Cleaned result{rock(), {}};
  result.report = add_natural_fractures(result.given, traces);
  return result;
}

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

std::vector<FractureLine> random_traces(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<FractureLine> traces;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = side * (uniform(random) - 0.5), y = side * (uniform(random) - 0.5),
                 angle = 7 * uniform(random);
    const double half = 3 + 17 * uniform(random);
    traces.push_back(trace(i, {x - half * std::cos(angle), y - half * std::sin(angle)},
                           {x + half * std::cos(angle), y + half * std::sin(angle)}));
  }
  return traces;
}

}  // namespace

TEST_CASE("a hundred lines through one point are cleaned into a valid mesh", "[structure][mesh][natural]") {
  std::vector<FractureLine> traces;
  for (std::size_t i = 0; i < 100; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / 100;
    traces.push_back(trace(i, {-40 * std::cos(angle), -40 * std::sin(angle)},
                           {40 * std::cos(angle), 40 * std::sin(angle)}));
  }
  const Cleaned result = cleaned(traces);
  CHECK(result.report.kept >=
        14);  // 15 lines at 12 degrees, and what is left of the others away from the point
  CHECK(result.report.cleaning.size() >= 85);
  check_mesh(result.given);
}

TEST_CASE("without cleaning, a hundred lines through one point are a clear fault",
          "[structure][mesh][natural][fault]") {
  Case given = rock();
  for (std::size_t i = 0; i < 100; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / 100;
    given.fractures.push_back(trace(i, {-40 * std::cos(angle), -40 * std::sin(angle)},
                                    {40 * std::cos(angle), 40 * std::sin(angle)}));
  }
  CHECK_THROWS_WITH(build_mesh(given), Catch::Contains("meet at 1.8 degrees at (0, 0) m"));
}

TEST_CASE(
    "duplicates, zero lengths, traces on and beyond the boundary and at less than one degree end in a valid "
    "mesh",
    "[structure][mesh][natural]") {
  const double rise = 30 * std::tan(0.7 * std::numbers::pi / 180);
  const Cleaned result =
      cleaned({trace(0, {-30, 0}, {30, 0}), trace(1, {-30, 0}, {30, 0}), trace(2, {30, 0}, {-30, 0}),
               trace(3, {-10, 0}, {45, 0}), trace(4, {5, 5}, {5, 5}), trace(5, {-50, -50}, {-50, 50}),
               trace(6, {-20, 50}, {20, 50}), trace(7, {20, 20}, {70, 70}), trace(8, {60, 0}, {90, 0}),
               trace(9, {-30, -rise}, {30, rise}), trace(10, {-30, 0}, {30, 2 * rise}),
               trace(11, {0, -49.9}, {0, 49.9}), trace(12, {-50, -50}, {50, 50})});
  CHECK(result.report.kept >= 4);
  check_mesh(result.given);
}

TEST_CASE("two hundred random dense traces are cleaned into a valid mesh", "[structure][mesh][natural]") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 4));
  const Cleaned result = cleaned(random_traces(200, seed));
  CHECK(result.report.kept > 60);
  check_mesh(result.given);
}

TEST_CASE("a cleaned network passes the arrangement of lines, whatever it was",
          "[structure][mesh][natural]") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Cleaned result{rock(), {}};
    add_line(result.given, "slit", {{-3, 1}, {4, 2}});
    result.given.mesh.natural_size = seed % 3 == 0 ? 0.25 : 0.5 * static_cast<double>(seed % 3);
    result.report = add_natural_fractures(result.given, random_traces(20 + 5 * seed, 100 + seed));
    CHECK_NOTHROW(arrange_lines(result.given));
  }
}

TEST_CASE("natural fractures have edges of natural_size, and finer ones near a finer line",
          "[structure][mesh][natural]") {
  Case given = rock();
  add_line(given, "slit", {{-3, 0}, {3, 0}});
  given.fractures.push_back(trace(1, {0, 10}, {0, 40}));
  given.fractures.push_back(trace(2, {0, 0}, {0, -30}));
  const PlanarMesh mesh = mesh_domain(given);
  double longest_of_slit = 0, shortest_far = side, longest_far = 0, longest_near = 0;
  for (const LineEdge& edge : mesh.line_edges) {
    const Point a = mesh.points[edge.begin], b = mesh.points[edge.end];
    const double long_by = distance(a, b);
    if (edge.line == 0) longest_of_slit = std::max(longest_of_slit, long_by);
    if (edge.line == 1) {
      shortest_far = std::min(shortest_far, long_by);
      longest_far = std::max(longest_far, long_by);
    }
    if (edge.line == 2 && a[1] > -given.mesh.corridor && b[1] > -given.mesh.corridor)
      longest_near = std::max(longest_near, long_by);
  }
  CHECK(longest_of_slit < 1.1 * given.mesh.fracture_size);
  // An edge may deviate from the size by what rounding to a whole number of them takes, and by the gradation
  // over its length.
  CHECK(shortest_far > natural / 1.2);
  CHECK(longest_far < 1.2 * natural);
  CHECK(longest_near < 1.2 * given.mesh.fracture_size);
}
