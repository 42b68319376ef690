// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "common/errors.hpp"
#include "structure/mesh/triangle_shape.hpp"
#include "structure/mesh/triangulate.hpp"

using namespace fissura;
using namespace fissura::structure;

namespace {

// A long edge with points so close on either side that no Delaunay triangulation would have it.
const std::vector<Point> around_an_edge{{0, 0}, {10, 0}, {3, 0.1}, {7, -0.1}, {5, 4}, {5, -4}};

}  // namespace

TEST_CASE("a constraint stays one edge however near other points are", "[structure][mesh]") {
  const std::vector<PointPair> edges{{0, 1}};
  const std::vector<PointTriple> triangles = triangulate(around_an_edge, edges);
  const auto has_edge = [](const PointTriple& t) { return t[0] == 0 && (t[1] == 1 || t[2] == 1); };
  CHECK(std::count_if(triangles.begin(), triangles.end(), has_edge) == 2);
  const std::vector<PointTriple> free = triangulate(around_an_edge, {});
  CHECK(std::count_if(free.begin(), free.end(), has_edge) == 0);
}

TEST_CASE("triangles are counter-clockwise, fill the convex hull and use every point", "[structure][mesh]") {
  std::set<std::uint32_t> used;
  double twice = 0;
  for (const PointTriple& t : triangulate(around_an_edge, {})) {
    const double one = twice_area(around_an_edge[t[0]], around_an_edge[t[1]], around_an_edge[t[2]]);
    CHECK(one > 0);
    twice += one;
    used.insert(t.begin(), t.end());
  }
  CHECK(twice / 2 == Approx(40).epsilon(1e-14));
  CHECK(used.size() == around_an_edge.size());
}

TEST_CASE("edges that cross or meet a point between their ends are refused", "[structure][mesh]") {
  const std::vector<Point> points{{0, 0}, {2, 0}, {1, -1}, {1, 1}, {4, 0}};
  const std::vector<PointPair> crossing_edges{{0, 1}, {2, 3}}, over_a_point{{0, 4}};
  CHECK_THROWS_AS(triangulate(points, crossing_edges), SolverError);
  CHECK_THROWS_AS(triangulate(points, over_a_point), SolverError);
}

TEST_CASE("coincident points are refused", "[structure][mesh]") {
  const std::vector<Point> points{{0, 0}, {2, 0}, {1, 1}, {2, 0}};
  CHECK_THROWS_AS(triangulate(points, {}), SolverError);
}
