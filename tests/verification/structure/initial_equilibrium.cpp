// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "structure/dynamics/central_difference.hpp"
#include "structure/dynamics/stable_step.hpp"
#include "tests/fakes/structure/jittered_mesh.hpp"
#include "tests/fakes/structure/shale_case.hpp"

/// The in-situ state is in equilibrium at zero displacement.

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

// Of the displacement the in-situ stress would cause if it were not balanced. Rounding of doubles stays
// below; the rounding of stresses stored in single precision would not.
constexpr double tolerance = 1e-12;
const Grid grid{40, 30, 80, 60, 0.2, 12};

Case gradient_case() {
  Case settings = stressed_shale_case();
  settings.in_situ.body_acceleration = {0, -9.81};
  settings.in_situ.pore_pressure_gradient = {0, -1000 * 9.81};
  settings.in_situ.stress_gradient = {{{400, 9e3}, {0, (2500 - 1000) * 9.81}, {0, -400}, {0, 1e4}}};
  return settings;
}

double unbalanced_displacement(const Case& settings) {
  return 30e6 / settings.rock.youngs_modulus * 0.5 * grid.width;
}

void all_sides(Case& settings, BoundaryKind kind) {
  for (Boundary* side :
       {&settings.boundary.west, &settings.boundary.east, &settings.boundary.south, &settings.boundary.north})
    side->kind = kind;
}

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

double moved_after(int steps, const Mesh& mesh, const Case& settings, std::vector<double>& joint_force) {
  const auto body = build_body(mesh, settings);
  const auto tiles = build_tiles(mesh, body, joint_nodes(mesh));
  const auto moduli = elasticity(settings.rock);
  const auto stiffest = stiffest_element(mesh, moduli, settings.rock.density);
  const Step step{stable_step(stiffest.frequency_squared, 0, {0.8, 1, 0}), 0, 1, 0};
  State state = state_at_rest(body);
  CentralDifference dynamics(body, tiles, moduli, 1);
  for (int i = 0; i < steps; ++i) dynamics.advance(state, step);
  joint_force = dynamics.joint_force();
  return largest(state.displacement);
}

}  // namespace

TEST_CASE("initial equilibrium: a turned in-situ stress moves nothing, whatever holds the sides",
          "[verification][structure]") {
  Case settings = stressed_shale_case();
  all_sides(settings, GENERATE(BoundaryKind::fixed, BoundaryKind::roller, BoundaryKind::traction));
  std::vector<double> unused;
  CHECK(moved_after(400, jittered_mesh(grid), settings, unused) <
        tolerance * unbalanced_displacement(settings));
}

TEST_CASE("initial equilibrium: stress and pore pressure that grow with depth balance gravity",
          "[verification][structure]") {
  Case settings = gradient_case();
  all_sides(settings, GENERATE(BoundaryKind::roller, BoundaryKind::traction));
  std::vector<double> unused;
  CHECK(moved_after(400, jittered_mesh(grid), settings, unused) <
        tolerance * unbalanced_displacement(settings));
}

TEST_CASE("initial equilibrium: a fluid at the total normal stress holds a slit in place",
          "[verification][structure]") {
  Case settings = shale_case();
  settings.in_situ.stress = {-15e6, -10.1234567e6, 0, -20e6};
  settings.in_situ.pore_pressure = 30e6;
  const double fluid_pressure = 40.1234567e6;
  const Mesh mesh = mesh_with_line(grid, 10.2);
  std::vector<double> joint_force;
  CHECK(moved_after(100, mesh, settings, joint_force) < tolerance * unbalanced_displacement(settings));

  const auto joints = joint_nodes(mesh);
  const auto place = [&](NodeIndex node) {
    return std::lower_bound(joints.begin(), joints.end(), node) - joints.begin();
  };
  for (const ContactUnit& unit : mesh.units)
    for (int axis = 0; axis < 2; ++axis) {
      const double load = fluid_pressure * unit.face[axis];
      CHECK(std::abs(joint_force[2 * place(unit.plus) + axis] + load) <
            tolerance * fluid_pressure * unit.length);
      CHECK(std::abs(joint_force[2 * place(unit.minus) + axis] - load) <
            tolerance * fluid_pressure * unit.length);
    }
}
