// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "structure/dynamics/central_difference.hpp"
#include "structure/dynamics/element_fields.hpp"
#include "tests/fakes/structure/jittered_mesh.hpp"
#include "tests/fakes/structure/shale_case.hpp"

/// Patch test (Irons & Razzaque 1972): a displacement that is linear in x and y gives an even stress in any
/// mesh, and no force on any inner node.

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

const Grid grid{20, 16, 60, 48, 0.25, 8};
constexpr double tolerance = 1e-10;                // rounding; any error of the element is far larger
constexpr double force_scale = 3.2e6 * 20.0 / 60;  // stress times edge length [N/m]

std::vector<double> even_strain(const Mesh& mesh) {
  std::vector<double> displacement;
  for (const auto& [x, y] : mesh.position)
    displacement.insert(displacement.end(), {1e-4 * x + 2e-5 * y, 3e-5 * x - 4e-5 * y});
  return displacement;
}

bool on_boundary(const Point& p) {
  return std::abs(p[0]) == 10 || std::abs(p[1]) == 8;
}

// Force on each node that the dynamics move: one undamped step from rest makes it visible as a velocity.
std::vector<double> nodal_force(const Body& body, State& state, CentralDifference& dynamics) {
  const double size = 1e-6;
  dynamics.advance(state, {size, 0, 1, 0});
  std::vector<double> force;
  for (std::size_t dof = 0; dof < state.velocity.size(); ++dof)
    force.push_back(state.velocity[dof] * body.mass[dof / 2] / size);
  return force;
}

}  // namespace

TEST_CASE("patch test: even strain gives the even stress of plane strain", "[verification][structure]") {
  const Mesh mesh = jittered_mesh(grid);
  const Case settings = shale_case();
  const auto body = build_body(mesh, settings);
  const auto moduli = elasticity(settings.rock);
  for (const auto& stress : effective_stress(mesh, body, moduli, even_strain(mesh), {})) {
    CHECK(stress.in_plane.xx == Approx(3.2e6).epsilon(tolerance));
    CHECK(stress.in_plane.yy == Approx(-1.6e6 / 3).epsilon(tolerance));
    CHECK(stress.in_plane.xy == Approx(2e6 / 3).epsilon(tolerance));
    CHECK(stress.out_of_plane == Approx(1.6e6 / 3).epsilon(tolerance));
  }
}

TEST_CASE("patch test: even strain puts no force on inner nodes", "[verification][structure]") {
  const Mesh mesh = jittered_mesh(grid);
  const Case settings = shale_case();
  const auto body = build_body(mesh, settings);
  const auto tiles = build_tiles(mesh, body, {});
  REQUIRE(tiles.shared.node.size() > 0);
  State state = state_at_rest(body);
  state.displacement = even_strain(mesh);
  CentralDifference dynamics(body, tiles, elasticity(settings.rock), 1);
  const auto force = nodal_force(body, state, dynamics);
  for (std::size_t node = 0; node < mesh.position.size(); ++node) {
    const double here = std::hypot(force[2 * node], force[2 * node + 1]);
    if (on_boundary(mesh.position[node]))
      CHECK(here > 0.1 * force_scale);
    else
      CHECK(here < tolerance * force_scale);
  }
}

TEST_CASE("patch test: the two faces of a tied line feel opposite forces", "[verification][structure]") {
  const Mesh mesh = mesh_with_line(grid, 5.05);
  REQUIRE(mesh.units.size() > 20);
  const Case settings = shale_case();
  const auto body = build_body(mesh, settings);
  const auto joints = joint_nodes(mesh);
  const auto tiles = build_tiles(mesh, body, joints);
  State state = state_at_rest(body);
  state.displacement = even_strain(mesh);
  CentralDifference dynamics(body, tiles, elasticity(settings.rock), 1);
  const auto force = nodal_force(body, state, dynamics);
  for (std::size_t node = 0; node < mesh.position.size(); ++node)
    if (!on_boundary(mesh.position[node]))
      CHECK(std::hypot(force[2 * node], force[2 * node + 1]) < tolerance * force_scale);

  const auto on_joint = [&](NodeIndex node, int axis) {
    const auto place = std::lower_bound(joints.begin(), joints.end(), node) - joints.begin();
    return dynamics.joint_force()[2 * place + axis];
  };
  for (const ContactUnit& unit : mesh.units) {
    const std::array<double, 2> traction{2e6 / 3 * unit.length, -1.6e6 / 3 * unit.length};
    for (int axis = 0; axis < 2; ++axis) {
      CHECK(std::abs(on_joint(unit.plus, axis) + on_joint(unit.minus, axis)) < tolerance * force_scale);
      CHECK(on_joint(unit.minus, axis) == Approx(-traction[axis]).epsilon(1e-8));
    }
  }
}
