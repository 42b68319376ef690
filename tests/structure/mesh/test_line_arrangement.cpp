// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "mesh_cases.hpp"
#include "structure/mesh/line_arrangement.hpp"
#include "structure/mesh/prescribed_points.hpp"

using namespace fissura;
using namespace fissura::structure;

namespace {

bool has_vertex(const LineArrangement& lines, Point wanted) {
  return std::any_of(lines.vertices.begin(), lines.vertices.end(),
                     [&](Point vertex) { return distance(vertex, wanted) < 1e-12; });
}

}  // namespace

TEST_CASE("lines are cut where they cross", "[structure][mesh]") {
  const LineArrangement lines = arrange_lines(crossing());
  CHECK(lines.vertices.size() == 5);
  CHECK(lines.pieces.size() == 4);
  CHECK(has_vertex(lines, {0, 0}));
}

TEST_CASE("a line is cut where another ends on it", "[structure][mesh]") {
  const LineArrangement lines = arrange_lines(touching());
  CHECK(lines.vertices.size() == 4);
  CHECK(lines.pieces.size() == 3);
}

TEST_CASE("an end that is off a line by rounding touches it", "[structure][mesh]") {
  Case given = touching();
  given.fractures[1].points.back() = {0, -0.9 * touch_tolerance * given.mesh.fracture_size};
  CHECK(arrange_lines(given).pieces.size() == 3);
}

TEST_CASE("three lines through one point share one vertex", "[structure][mesh]") {
  Case given = crossing();
  add_line(given, "third", {{2, -3}, {-2, 3}});
  const LineArrangement lines = arrange_lines(given);
  CHECK(lines.vertices.size() == 7);
  CHECK(lines.pieces.size() == 6);
}

TEST_CASE("given points, ends of continued lines and perforations are vertices", "[structure][mesh]") {
  Case given = square(40);
  add_line(given, "slit", {{-1.1, 0}, {0.3, 0}, {1.1, 0.2}});
  add_line(given, "wing", {{1.1, 0.2}, {5, 0.2}});
  given.injection.perforations.push_back({"p", {-0.37, 0}, 0});
  const LineArrangement lines = arrange_lines(given);
  CHECK(lines.vertices.size() == 5);
  for (const Point point : {Point{-1.1, 0}, Point{0.3, 0}, Point{1.1, 0.2}, Point{5, 0.2}, Point{-0.37, 0}})
    CHECK(has_vertex(lines, point));
}

TEST_CASE("the points of a piece of line are equally spaced at about the fracture size",
          "[structure][mesh]") {
  Case given = square(40);
  add_line(given, "slit", {{-3.3, 0}, {4.1, 1}});
  const LineArrangement lines = arrange_lines(given);
  const SizeField field(given.mesh, stretches(lines, given), {});
  const PrescribedPoints prescribed = prescribe_points(lines, field, given);
  const double total = std::hypot(7.4, 1);
  REQUIRE(prescribed.line_edges.size() == 15);
  for (const LineEdge& edge : prescribed.line_edges)
    CHECK(distance(prescribed.points[edge.begin], prescribed.points[edge.end]) ==
          Approx(total / 15).epsilon(1e-12));
}

TEST_CASE("the number of edges is the one whose length is nearest to the target by ratio",
          "[structure][mesh]") {
  CHECK(edge_count(10, 0.5) == 20);
  CHECK(edge_count(0.1, 0.5) == 1);
  CHECK(edge_count(0.5 * 1.41, 0.5) == 1);
  CHECK(edge_count(0.5 * 1.42, 0.5) == 2);
}
