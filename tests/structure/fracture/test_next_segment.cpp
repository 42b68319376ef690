// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "structure/fracture/next_segment.hpp"

using namespace fissura;
using namespace fissura::structure;

namespace {

constexpr double h = 0.5;
constexpr std::array<double, 2> east{1, 0};
const Domain domain{20, 20, 1};

/// Fractures alone; no rock is needed to look for the next segment.
struct Lines {
  Mesh mesh;

  Lines() { mesh.lines.resize(1); }

  /// Adds a polyline; @returns its first vertex.
  VertexIndex add(const std::vector<Point>& points) {
    const auto first = static_cast<VertexIndex>(mesh.vertices.size());
    for (const Point& point : points) {
      mesh.vertices.push_back({point, {}, static_cast<NodeIndex>(mesh.position.size()), {}});
      mesh.position.push_back(point);
    }
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      join(first + static_cast<VertexIndex>(k), first + static_cast<VertexIndex>(k) + 1);
    return first;
  }

  void join(VertexIndex a, VertexIndex b) {
    const Point &p = mesh.vertices[a].position, &q = mesh.vertices[b].position;
    add_edge(mesh, {a, b, 0, std::hypot(q[0] - p[0], q[1] - p[1])});
  }

  void add_side_node(Side side, Point at) {
    mesh.side_nodes[static_cast<std::size_t>(side)].push_back(static_cast<NodeIndex>(mesh.position.size()));
    mesh.position.push_back(at);
  }

  [[nodiscard]] FractureTip tip(Point at) const {
    for (const FractureTip& tip : fracture_tips(mesh))
      if (tip.position == at) return tip;
    throw std::logic_error("no tip there");
  }

  [[nodiscard]] NextSegment next(Point at, const std::array<double, 2>& direction) const {
    return next_segment(mesh, domain, tip(at), direction, h, h);
  }
};

InPlane<double> tension_along(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {1e6 * c * c - 3e6, 1e6 * s * s - 3e6, 1e6 * c * s};
}

}  // namespace

TEST_CASE("growth is perpendicular to the greatest principal stress and turns the shorter way",
          "[structure][fracture]") {
  const double across = GENERATE(1.2, 1.57, 1.9, 0.4 + std::numbers::pi);
  const auto direction = growth_direction(tension_along(across), east, 1.5);
  CHECK(direction[0] == Approx(std::abs(std::sin(across))).epsilon(1e-12));
  CHECK(std::abs(direction[0] * std::cos(across) + direction[1] * std::sin(across)) < 1e-12);
  const auto back = growth_direction(tension_along(across), {-1, 0}, 1.5);
  CHECK(back[0] == Approx(-direction[0]).epsilon(1e-12));
  CHECK(back[1] == Approx(-direction[1]).epsilon(1e-12));
}

TEST_CASE("a turn beyond the limit is cut off there, to the side it was meant for", "[structure][fracture]") {
  const double limit = 0.5, sign = GENERATE(1.0, -1.0);
  // Tension nearly along the fracture asks for a turn of 80 degrees.
  const auto direction = growth_direction(tension_along(std::numbers::pi / 2 + sign * 1.4), east, limit);
  CHECK(direction[0] == Approx(std::cos(limit)).epsilon(1e-12));
  CHECK(direction[1] == Approx(sign * std::sin(limit)).epsilon(1e-12));
}

TEST_CASE("in sound rock the segment has its length and direction", "[structure][fracture]") {
  Lines lines;
  lines.add({{-1, 0}, {-0.5, 0}, {0, 0}});
  const std::array<double, 2> direction{std::cos(0.3), std::sin(0.3)};
  const NextSegment segment = lines.next({0, 0}, direction);
  REQUIRE(segment.end);
  CHECK_FALSE(segment.obstacle);
  CHECK(segment.end->kind == SegmentEnd::Kind::rock);
  CHECK(segment.end->position[0] == Approx(h * direction[0]).epsilon(1e-14));
  CHECK(segment.end->position[1] == Approx(h * direction[1]).epsilon(1e-14));
}

TEST_CASE("a fracture does not run into itself", "[structure][fracture]") {
  Lines lines;
  lines.add({{0, 0}, {0.5, 0}, {1, 0}, {1.5, 0}, {1.5, 0.5}, {1, 0.5}});
  const NextSegment segment = lines.next({1, 0.5}, {-0.6, -0.8});
  CHECK_FALSE(segment.end);
  CHECK(segment.obstacle == Obstacle::own_fracture);
  CHECK(lines.next({1, 0.5}, {-1, 0}).end);
}

TEST_CASE("a fracture ends on another one at the vertex most nearly ahead", "[structure][fracture]") {
  Lines lines;
  lines.add({{-1, 0}, {-0.5, 0}, {0, 0}});
  const double away = GENERATE(0.2, 0.45, 0.8);  // crossed, or too near to what is left
  const VertexIndex wall = lines.add({{away, -1.1}, {away, -0.6}, {away, -0.1}, {away, 0.4}, {away, 0.9}});
  const NextSegment segment = lines.next({0, 0}, east);
  REQUIRE(segment.end);
  CHECK(segment.end->kind == SegmentEnd::Kind::fracture);
  CHECK(segment.end->vertex == wall + 2);
  CHECK(segment.end->position == Point{away, -0.1});
}

TEST_CASE("two tips that face each other join", "[structure][fracture]") {
  Lines lines;
  lines.add({{-1, 0}, {-0.5, 0}, {0, 0}});
  const VertexIndex other = lines.add({{0.8, 0.1}, {1.3, 0.1}});
  const NextSegment segment = lines.next({0, 0}, east);
  REQUIRE(segment.end);
  CHECK(segment.end->kind == SegmentEnd::Kind::fracture);
  CHECK(segment.end->vertex == other);
}

TEST_CASE("a fracture joins another one that it is connected to elsewhere", "[structure][fracture]") {
  Lines lines;
  const VertexIndex start = lines.add({{-2, 0}, {-1.5, 0}, {-1, 0}, {-0.5, 0}, {0, 0}});
  const VertexIndex wall = lines.add({{0.4, -1}, {0.4, -0.5}, {0.4, 0}, {0.4, 0.5}});
  lines.join(start, wall);
  const NextSegment segment = lines.next({0, 0}, east);
  REQUIRE(segment.end);
  CHECK(segment.end->vertex == wall + 2);
}

TEST_CASE("a fracture that has crossed another one at a sharp angle leaves its arms behind",
          "[structure][fracture]") {
  Lines lines;
  lines.add({{-0.5, 0}, {0, 0}, {0.5, 0}});
  const VertexIndex arm = lines.add({{0.43, 0.25}, {0.86, 0.5}});
  lines.join(1, arm);
  CHECK(lines.next({0.5, 0}, east).end);
  CHECK(lines.next({0.5, 0}, {0.6, 0.8}).obstacle == Obstacle::own_fracture);
}

TEST_CASE("a fracture waits before another one that it would cross between vertices out of reach",
          "[structure][fracture]") {
  Lines lines;
  lines.add({{-1, 0}, {-0.5, 0}, {0, 0}});
  lines.add({{0.4, -3}, {0.4, 3}});
  CHECK(lines.next({0, 0}, east).obstacle == Obstacle::no_vertex_to_join);
}

TEST_CASE("a fracture does not join another one at a sharp angle", "[structure][fracture]") {
  Lines lines;
  lines.add({{-1, 0}, {-0.5, 0}, {0, 0}});
  // Seen from its second vertex the tip lies within 20 degrees of its first edge.
  const VertexIndex other = lines.add({{-0.4, 0.2}, {0.9, 0.05}, {1.1, -0.4}});
  const NextSegment segment = lines.next({0, 0}, east);
  REQUIRE(segment.end);
  CHECK(segment.end->vertex == other + 2);
}

TEST_CASE("a fracture breaks through to the side where little rock would be left", "[structure][fracture]") {
  Lines lines;
  lines.add({{8, 0}, {8.5, 0}, {9, 0}});
  lines.add_side_node(Side::east, {10, -0.4});
  lines.add_side_node(Side::east, {10, 0.1});
  const NextSegment through = lines.next({9, 0}, east);
  REQUIRE(through.end);
  CHECK(through.end->kind == SegmentEnd::Kind::boundary);
  CHECK(through.end->position == Point{10, 0.1});
  CHECK(lines.mesh.position[through.end->node] == Point{10, 0.1});
  CHECK(lines.next({9, 0}, {-0.6, 0.8}).end->kind == SegmentEnd::Kind::rock);
}

TEST_CASE("a fracture waits before a side without a node in reach, and does not break through at a corner",
          "[structure][fracture]") {
  Lines lines;
  lines.add({{8.5, 9.4}, {9, 9.4}, {9.4, 9.4}});
  lines.add_side_node(Side::east, {10, 10});
  lines.add_side_node(Side::east, {10, 6});
  CHECK(lines.next({9.4, 9.4}, east).obstacle == Obstacle::boundary_too_coarse);
}

TEST_CASE("tips are the unsplit ends of open and of grown fractures", "[structure][fracture]") {
  Lines lines;
  lines.mesh.lines.resize(2);
  lines.mesh.lines[1].kind = FractureKind::natural;
  lines.add({{-1, 0}, {0, 0}, {0, 2}});
  const std::size_t open_edges = lines.mesh.edges.size();
  lines.add({{5, 5}, {6, 5}});
  for (std::size_t k = open_edges; k < lines.mesh.edges.size(); ++k) lines.mesh.edges[k].line = 1;
  const auto tips = fracture_tips(lines.mesh);
  REQUIRE(tips.size() == 2);
  CHECK(tips[0].vertex == 0);
  CHECK(tips[0].direction == std::array<double, 2>{-1, 0});
  CHECK(tips[1].vertex == 2);
  CHECK(tips[1].previous == 1);
  CHECK(tips[1].direction == std::array<double, 2>{0, 1});
}
