// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "mesh_cases.hpp"
#include "structure/mesh/build_mesh.hpp"
#include "structure/mesh/mesh_quality.hpp"

using namespace fissura;
using namespace fissura::structure;

TEST_CASE("the areas sum to that of the domain and every one is positive", "[structure][mesh]") {
  const auto given = GENERATE(square(40), single_line(), crossing(), touching());
  const Mesh mesh = build_mesh(given);
  CHECK(area(mesh) == Approx(1600).epsilon(1e-12));
  for (ElementIndex e = 0; e < mesh.elements.size(); ++e) REQUIRE(element_area(mesh, e) > 0);
}

TEST_CASE("the same case gives the same bits", "[structure][mesh]") {
  CHECK(measure(build_mesh(crossing())).hash == measure(build_mesh(crossing())).hash);
}

TEST_CASE("another seed gives another mesh with the same lines", "[structure][mesh]") {
  Case given = crossing();
  const Mesh one = build_mesh(given);
  given.mesh.seed = 2;
  const Mesh other = build_mesh(given);
  CHECK(measure(one).hash != measure(other).hash);
  REQUIRE(one.vertices.size() == other.vertices.size());
  for (std::size_t v = 0; v < one.vertices.size(); ++v)
    CHECK(one.vertices[v].position == other.vertices[v].position);
}

TEST_CASE("the side nodes stand on the sides and reach from corner to corner", "[structure][mesh]") {
  Case given = square(20);
  given.domain.height = 12;
  const Mesh mesh = build_mesh(given);
  const double coordinate[4] = {-10, 10, -6, 6};
  for (std::size_t side = 0; side < 4; ++side) {
    const int across = side < 2 ? 0 : 1;
    double low = 0, high = 0;
    for (const NodeIndex node : mesh.side_nodes[side]) {
      CHECK(mesh.position[node][across] == coordinate[side]);
      low = std::min(low, mesh.position[node][1 - across]);
      high = std::max(high, mesh.position[node][1 - across]);
    }
    CHECK(low == (side < 2 ? -6 : -10));
    CHECK(high == (side < 2 ? 6 : 10));
  }
}

TEST_CASE("the quality of one right-angled triangle is that of geometry", "[structure][mesh]") {
  Mesh mesh;
  mesh.position = {{0, 0}, {4, 0}, {0, 3}};
  mesh.elements = {{0, 1, 2}};
  const MeshQuality quality = measure(mesh);
  CHECK(quality.elements == 1);
  CHECK(quality.nodes == 3);
  CHECK(quality.smallest_angle == Approx(std::atan2(3, 4) * 180 / M_PI).epsilon(1e-12));
  CHECK(quality.smallest_altitude == Approx(12.0 / 5).epsilon(1e-12));
  CHECK(quality.smallest_edge == 3);
  CHECK(quality.largest_edge == 5);
}

TEST_CASE("report: size, quality and time of typical meshes", "[.][report]") {
  fmt::print("line 32 m in a square of 400 m, far size 40 m\n");
  fmt::print("{:>7} {:>9} {:>10} {:>9} {:>8} {:>10} {:>12} {:>7}\n", "h [m]", "corridor", "gradation",
             "elements", "nodes", "angle", "altitude/h", "time");
  for (const auto& [size, corridor, gradation] : std::vector<std::array<double, 3>>{{0.5, 3, 0.15},
                                                                                    {0.5, 3, 0.3},
                                                                                    {0.25, 1.5, 0.15},
                                                                                    {0.25, 1.5, 0.3},
                                                                                    {0.25, 2.5, 0.3},
                                                                                    {0.125, 0.75, 0.15},
                                                                                    {0.1, 0.6, 0.1},
                                                                                    {0.05, 0.3, 0.02}}) {
    Case given = square(400);
    given.mesh = {.fracture_size = size,
                  .far_size = 40,
                  .corridor = corridor,
                  .gradation = gradation,
                  .lattice_angle = {},
                  .refinements = {}};
    add_line(given, "path", {{-16, 0}, {16, 0}});
    const auto start = std::chrono::steady_clock::now();
    const Mesh mesh = build_mesh(given);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    const MeshQuality quality = measure(mesh);
    fmt::print("{:7} {:9} {:10} {:9} {:8} {:6.1f} deg {:12.2f} {:5.1f} s\n", size, corridor, gradation,
               quality.elements, quality.nodes, quality.smallest_angle, quality.smallest_altitude / size,
               time.count());
  }
}
