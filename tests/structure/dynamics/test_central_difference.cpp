// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "structure/dynamics/central_difference.hpp"
#include "structure/dynamics/stable_step.hpp"
#include "tests/fakes/structure/jittered_mesh.hpp"
#include "tests/fakes/structure/naive_structure.hpp"
#include "tests/fakes/structure/shale_case.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

TEST_CASE("local damping takes its share of the force against the motion", "[structure][dynamics]") {
  const Step step{0.1, 0, 4, 0.25};
  const StepFactors factors(step);
  const double inverse_mass = 0.5, force = GENERATE(8.0, -8.0);
  const Pair forces{force, 0}, inverse_masses{inverse_mass, inverse_mass};
  const double undamped = step.size / step.mass_scale * inverse_mass * force;
  double velocity[2] = {0, 3}, displacement[2] = {1, 0};
  integrate(forces, inverse_masses, factors, velocity, displacement);
  CHECK(velocity[0] == Approx(undamped).epsilon(1e-15));  // at rest there is nothing to damp
  CHECK(displacement[0] == Approx(1 + step.size * undamped).epsilon(1e-15));
  CHECK(velocity[1] == 3);  // nor without a force
  CHECK(displacement[1] == Approx(3 * step.size).epsilon(1e-15));
  const double before = velocity[0];
  integrate(forces, inverse_masses, factors, velocity, displacement);
  CHECK(velocity[0] - before == Approx(0.75 * undamped).epsilon(1e-14));
  const double moving = velocity[0];
  integrate(-forces, inverse_masses, factors, velocity, displacement);
  CHECK(velocity[0] - moving == Approx(-1.25 * undamped).epsilon(1e-14));
}

TEST_CASE("a prescribed side follows its ramp and then rests", "[structure][dynamics]") {
  const Mesh mesh = jittered_mesh({10, 10, 10, 10, 0.2, 1});
  Case settings = shale_case();
  settings.boundary.east = {BoundaryKind::displacement, {1e-3, -2e-3}, 0.5};
  const auto body = build_body(mesh, settings);
  const auto tiles = build_tiles(mesh, body, {});
  State state = state_at_rest(body);
  CentralDifference dynamics(body, tiles, elasticity(settings.rock), 1);
  const double size = 0.125;
  for (int i = 1; i <= 6; ++i) {
    dynamics.advance(state, {size, i * size, 1e9, 0});
    const double fraction = std::min(1.0, i * size / 0.5);
    for (const NodeIndex node : mesh.side_nodes[1]) {
      CHECK(state.displacement[2 * node] == Approx(fraction * 1e-3).epsilon(1e-14));
      CHECK(state.displacement[2 * node + 1] == Approx(-fraction * 2e-3).epsilon(1e-14));
      CHECK(state.velocity[2 * node] == Approx(i <= 4 ? 1e-3 / 0.5 : 0).margin(1e-15));
    }
  }
}

TEST_CASE("forces on the two faces of a line add up to the force on the undivided nodes",
          "[structure][dynamics]") {
  const Grid grid{40, 40, 70, 70, 0.2, 4};
  const Mesh mesh = mesh_with_line(grid, 12.3);
  const Case settings = shale_case();
  const auto body = build_body(mesh, settings);
  const auto tiles = build_tiles(mesh, body, joint_nodes(mesh));
  REQUIRE(tiles.tile.size() > 1);
  State state = state_at_rest(body);
  for (std::size_t node = 0; node < mesh.position.size(); ++node) {
    const auto& [x, y] = mesh.position[node];
    state.displacement[2 * node] = 1e-5 * std::sin(0.3 * x + 0.2 * y);
    state.displacement[2 * node + 1] = 1e-5 * std::cos(0.2 * x - 0.4 * y);
  }
  const auto displaced = state.displacement;
  CentralDifference dynamics(body, tiles, elasticity(settings.rock), 2);
  const Step step{1e-6, 0, 1, 0};
  dynamics.advance(state, step);

  NaiveStructure reference(mesh, body, elasticity(settings.rock), std::nullopt);
  reference.set_displacement(displaced);
  reference.advance(step);
  const auto velocity = reference.velocity();
  REQUIRE(tiles.joint.node.size() == dynamics.joint_force().size() / 2);
  for (std::size_t i = 0; i < tiles.joint.node.size(); ++i) {
    const NodeIndex node = tiles.joint.node[i];
    for (int axis = 0; axis < 2; ++axis) {
      const double force = velocity[2 * node + axis] * body.mass[node] / step.size;
      CHECK(dynamics.joint_force()[2 * i + axis] ==
            Approx(force).margin(1e-7));  // [N/m] beside forces of 1e5
      CHECK(state.displacement[2 * node + axis] == displaced[2 * node + axis]);
      CHECK(state.velocity[2 * node + axis] == 0);
    }
  }
}
