// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <numeric>
#include <string>

#include "common/errors.hpp"
#include "structure/dynamics/body.hpp"
#include "tests/fakes/structure/jittered_mesh.hpp"
#include "tests/fakes/structure/shale_case.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

const Grid grid{10, 8, 10, 8, 0.2, 1};

double total_force(const Body& body, int axis) {
  double sum = 0;
  for (std::size_t dof = axis; dof < body.external_force.size(); dof += 2) sum += body.external_force[dof];
  return sum;
}

const PrescribedNode* prescribed_at(const Body& body, const Mesh& mesh, const Point& position) {
  for (const auto& prescribed : body.prescribed)
    if (mesh.position[prescribed.node] == position) return &prescribed;
  return nullptr;
}

}  // namespace

TEST_CASE("body: the lumped masses add up to density times area", "[structure][dynamics]") {
  const auto body = build_body(jittered_mesh(grid), shale_case());
  CHECK(std::accumulate(body.mass.begin(), body.mass.end(), 0.0) == Approx(2500 * 80).epsilon(1e-12));
}

TEST_CASE("body: an added traction pulls with traction times side length", "[structure][dynamics]") {
  Case settings = shale_case();
  settings.boundary.east.value = {2e6, -3e6};
  const auto body = build_body(jittered_mesh(grid), settings);
  CHECK(total_force(body, 0) == Approx(2e6 * 8).epsilon(1e-12));
  CHECK(total_force(body, 1) == Approx(-3e6 * 8).epsilon(1e-12));
}

TEST_CASE("body: a body force without the stress that balances it is refused, naming a node",
          "[structure][dynamics]") {
  Case settings = stressed_shale_case();
  settings.in_situ.body_acceleration = {0, -9.81};
  try {
    build_body(jittered_mesh(grid), settings);
    FAIL("an unbalanced body force was accepted");
  } catch (const SolverError& error) {
    CHECK(std::string(error.what()).find("node ") != std::string::npos);
    CHECK(std::string(error.what()).find("in y") != std::string::npos);
  }
  settings.in_situ.stress_gradient[1] = {0, 2500 * 9.81};
  CHECK_NOTHROW(build_body(jittered_mesh(grid), settings));
}

TEST_CASE("body: rollers hold the normal component, fixed sides both, corners obey both sides",
          "[structure][dynamics]") {
  Case settings = shale_case();
  settings.boundary.west.kind = BoundaryKind::roller;
  settings.boundary.south.kind = BoundaryKind::roller;
  settings.boundary.north.kind = BoundaryKind::fixed;
  const Mesh mesh = jittered_mesh(grid);
  const auto body = build_body(mesh, settings);
  for (std::size_t node = 0; node < mesh.position.size(); ++node) {
    const auto& [x, y] = mesh.position[node];
    const bool north = y == 4;
    CHECK((body.inverse_mass[node][0] == 0) == (north || x == -5));
    CHECK((body.inverse_mass[node][1] == 0) == (north || y == -4));
  }
}

TEST_CASE("body: at a corner of two displaced sides each gives its normal component",
          "[structure][dynamics]") {
  Case settings = shale_case();
  settings.boundary.east = {BoundaryKind::displacement, {-1e-3, 5e-3}, 2};
  settings.boundary.north = {BoundaryKind::displacement, {7e-3, -2e-3}, 2};
  settings.boundary.south.kind = BoundaryKind::roller;
  settings.boundary.west.kind = BoundaryKind::fixed;
  const Mesh mesh = jittered_mesh(grid);
  const auto body = build_body(mesh, settings);
  REQUIRE(prescribed_at(body, mesh, {5, 4}) != nullptr);
  CHECK(prescribed_at(body, mesh, {5, 4})->displacement == std::array<double, 2>{-1e-3, -2e-3});
  REQUIRE(prescribed_at(body, mesh, {5, -4}) != nullptr);
  CHECK(prescribed_at(body, mesh, {5, -4})->displacement == std::array<double, 2>{-1e-3, 0});
  CHECK(prescribed_at(body, mesh, {-5, 4}) == nullptr);
  CHECK(body.prescribed.size() == 11 + 9 - 1 - 1);
}

TEST_CASE("body: a fracture that reaches a displaced side is refused by name", "[structure][dynamics]") {
  Case settings = shale_case();
  settings.boundary.south = {BoundaryKind::displacement, {0, 0}, 0};
  settings.fractures.push_back({.name = "slit", .kind = FractureKind::open, .points = {}, .set = {}});
  Mesh mesh = mesh_with_line(grid, 2.5);
  mesh.lines = settings.fractures;
  CHECK_NOTHROW(build_body(mesh, settings));
  mesh.side_nodes[2].push_back(mesh.units.front().minus);
  CHECK_THROWS_WITH(build_body(mesh, settings), Catch::Contains("'slit'") && Catch::Contains("south"));
}
