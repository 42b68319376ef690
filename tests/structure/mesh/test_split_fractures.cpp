// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "mesh_cases.hpp"
#include "structure/mesh/build_mesh.hpp"

using namespace fissura;
using namespace fissura::structure;

namespace {

const FractureVertex& vertex_at(const Mesh& mesh, Point place) {
  const auto found =
      std::find_if(mesh.vertices.begin(), mesh.vertices.end(),
                   [&](const FractureVertex& vertex) { return distance(vertex.position, place) < 1e-9; });
  REQUIRE(found != mesh.vertices.end());
  return *found;
}

long nodes_at(const Mesh& mesh, Point place) {
  return std::count_if(mesh.position.begin(), mesh.position.end(),
                       [&](Point node) { return distance(node, place) < 1e-9; });
}

double unit_length(const Mesh& mesh) {
  double sum = 0;
  for (const ContactUnit& unit : mesh.units) sum += unit.length;
  return sum;
}

// Mean position of the elements at a node, seen from the node.
Point towards_elements(const Mesh& mesh, NodeIndex node) {
  Point sum{};
  for (const auto& element : mesh.elements)
    if (std::find(element.begin(), element.end(), node) != element.end())
      for (const NodeIndex corner : element)
        for (int k : {0, 1}) sum[k] += mesh.position[corner][k] - mesh.position[node][k];
  return sum;
}

}  // namespace

TEST_CASE("a slit is split everywhere but at its ends", "[structure][mesh][split]") {
  const Mesh mesh = build_mesh(single_line());
  CHECK(mesh.vertices.size() == 21);
  CHECK(mesh.edges.size() == 20);
  CHECK(mesh.units.size() == 19);
  for (const FractureVertex& vertex : mesh.vertices) {
    const bool is_end = std::abs(vertex.position[0]) == 5;
    CHECK(vertex.units.size() == (is_end ? 0 : 1));
    CHECK(nodes_at(mesh, vertex.position) == (is_end ? 1 : 2));
    CHECK(mesh.position[vertex.node] == vertex.position);
  }
}

TEST_CASE("vertices and edges follow each line", "[structure][mesh][split]") {
  const Mesh mesh = build_mesh(touching());
  std::vector<double> x;
  for (const FractureEdge& edge : mesh.edges)
    if (edge.line == 0) x.push_back(mesh.vertices[edge.begin].position[0]);
  CHECK(x.size() == 16);
  CHECK(std::is_sorted(x.begin(), x.end()));
  for (std::size_t i = 0; i + 1 < mesh.edges.size(); ++i) {
    if (mesh.edges[i].line == mesh.edges[i + 1].line) CHECK(mesh.edges[i].end == mesh.edges[i + 1].begin);
    CHECK(mesh.edges[i].line <= mesh.edges[i + 1].line);
  }
}

TEST_CASE("the face vector is the half edges turned left, from the minus to the plus side",
          "[structure][mesh][split]") {
  Case given = square(40);
  add_line(given, "oblique", {{-3, -2}, {3, 2}});
  const Mesh mesh = build_mesh(given);
  const double spacing = mesh.edges[0].length;
  for (const ContactUnit& unit : mesh.units) {
    CHECK(mesh.position[unit.minus] == mesh.position[unit.plus]);
    CHECK(unit.length == Approx(spacing).epsilon(1e-12));
    CHECK(unit.face[0] == Approx(-2 / std::hypot(2, 3) * spacing).epsilon(1e-12));
    CHECK(unit.face[1] == Approx(3 / std::hypot(2, 3) * spacing).epsilon(1e-12));
    const Point plus = towards_elements(mesh, unit.plus), minus = towards_elements(mesh, unit.minus);
    CHECK(plus[0] * unit.face[0] + plus[1] * unit.face[1] > 0);
    CHECK(minus[0] * unit.face[0] + minus[1] * unit.face[1] < 0);
  }
}

TEST_CASE("the lengths of the units sum to that of the lines less half an edge at each tip",
          "[structure][mesh][split]") {
  CHECK(unit_length(build_mesh(single_line())) == Approx(10 - 0.5).epsilon(1e-12));
  CHECK(unit_length(build_mesh(crossing())) == Approx(16 - 4 * 0.25).epsilon(1e-12));
  CHECK(unit_length(build_mesh(touching())) == Approx(12 - 3 * 0.25).epsilon(1e-12));
}

TEST_CASE("a T has three nodes and three units, an X four of each", "[structure][mesh][split]") {
  const Mesh t = build_mesh(touching());
  CHECK(nodes_at(t, {0, 0}) == 3);
  CHECK(vertex_at(t, {0, 0}).units.size() == 3);
  const Mesh x = build_mesh(crossing());
  CHECK(nodes_at(x, {0, 0}) == 4);
  CHECK(vertex_at(x, {0, 0}).units.size() == 4);
}

TEST_CASE("three lines through a point have six nodes and six units there", "[structure][mesh][split]") {
  Case given = crossing();
  add_line(given, "third", {{2, -3}, {-2, 3}});
  const Mesh mesh = build_mesh(given);
  CHECK(nodes_at(mesh, {0, 0}) == 6);
  CHECK(vertex_at(mesh, {0, 0}).units.size() == 6);
}

TEST_CASE("at a T each arm has its own unit with its own normal", "[structure][mesh][split]") {
  const Mesh mesh = build_mesh(touching());
  int level = 0, upright = 0;
  for (const UnitIndex u : vertex_at(mesh, {0, 0}).units) {
    const ContactUnit& unit = mesh.units[u];
    CHECK(unit.length == Approx(0.25).epsilon(1e-12));
    level += unit.line == 0 && std::abs(unit.face[1] - 0.25) < 1e-12;
    upright += unit.line == 1 && std::abs(unit.face[0] + 0.25) < 1e-12;
  }
  CHECK(level == 2);
  CHECK(upright == 1);
}

TEST_CASE("a bend is one unit whose face vector is the sum over both edges", "[structure][mesh][split]") {
  Case given = square(40);
  add_line(given, "bent", {{-3, 0}, {0, 0}, {0, 3}});
  const Mesh mesh = build_mesh(given);
  const FractureVertex& bend = vertex_at(mesh, {0, 0});
  REQUIRE(bend.units.size() == 1);
  const ContactUnit& unit = mesh.units[bend.units[0]];
  CHECK(unit.length == Approx(0.5).epsilon(1e-12));
  CHECK(unit.face[0] == Approx(-0.25).epsilon(1e-12));
  CHECK(unit.face[1] == Approx(0.25).epsilon(1e-12));
}

TEST_CASE("lines that continue one another share one unit, of the stronger line",
          "[structure][mesh][split]") {
  Case given = square(40);
  add_line(given, "slit", {{-1, 0}, {1, 0}});
  const bool reversed = GENERATE(false, true);
  if (reversed)
    add_line(given, "wing", {{5, 0}, {1, 0}});
  else
    add_line(given, "wing", {{1, 0}, {5, 0}});
  given.fractures[1].tensile_strength = 2e6;
  const Mesh mesh = build_mesh(given);
  const FractureVertex& joint = vertex_at(mesh, {1, 0});
  REQUIRE(joint.units.size() == 1);
  const ContactUnit& unit = mesh.units[joint.units[0]];
  CHECK(unit.line == 1);
  CHECK(unit.length == Approx(0.5).epsilon(1e-12));
  CHECK(unit.face[0] == Approx(0).margin(1e-12));
  CHECK(unit.face[1] == Approx(0.5).epsilon(1e-12));
}

TEST_CASE("every connected set of lines in the rock makes one hole", "[structure][mesh][split]") {
  CHECK(euler_characteristic(build_mesh(square(40))) == 1);
  CHECK(euler_characteristic(build_mesh(single_line())) == 0);
  CHECK(euler_characteristic(build_mesh(crossing())) == 0);
  Case two = touching();
  add_line(two, "apart", {{-4, 6}, {4, 7}});
  CHECK(euler_characteristic(build_mesh(two)) == -1);
}

TEST_CASE("a line from side to side parts the plate", "[structure][mesh][split]") {
  Case given = square(20);
  add_line(given, "through", {{-10, 0}, {10, 1}});
  const Mesh mesh = build_mesh(given);
  CHECK(euler_characteristic(mesh) == 2);
  CHECK(unit_length(mesh) == Approx(std::hypot(20, 1)).epsilon(1e-12));
  CHECK(std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                    [](const FractureVertex& vertex) { return vertex.units.size() == 1; }));
}

TEST_CASE("a closed line frees the block inside it", "[structure][mesh][split]") {
  Case given = square(40);
  add_line(given, "loop", {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}, {-2, -2}});
  const Mesh mesh = build_mesh(given);
  CHECK(euler_characteristic(mesh) == 1);  // a plate and a plate with a hole
  CHECK(unit_length(mesh) == Approx(16).epsilon(1e-12));
  Point sum{};
  for (const ContactUnit& unit : mesh.units)
    for (int k : {0, 1}) sum[k] += unit.face[k];
  CHECK(std::hypot(sum[0], sum[1]) < 1e-12);
}
