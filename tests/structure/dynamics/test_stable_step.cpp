// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "common/errors.hpp"
#include "structure/dynamics/central_difference.hpp"
#include "structure/dynamics/stable_step.hpp"
#include "tests/fakes/structure/jittered_mesh.hpp"
#include "tests/fakes/structure/shale_case.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

Mesh single_triangle(const Point& a, const Point& b, const Point& c) {
  Mesh mesh;
  mesh.position = {a, b, c};
  mesh.elements = {{0, 1, 2}};
  return mesh;
}

const Grid irregular{6, 6, 12, 12, 0.2, 2};

struct FreeBody {
  Mesh mesh = jittered_mesh(irregular);
  Case settings = shale_case();
  Elasticity moduli = elasticity(settings.rock);
  Body body = build_body(mesh, settings);
  Tiles tiles = build_tiles(mesh, body, {});

  [[nodiscard]] State disturbed() const {
    State state = state_at_rest(body);
    for (std::size_t dof = 0; dof < state.velocity.size(); ++dof)
      state.velocity[dof] = 1e-3 * std::sin(12.9898 * static_cast<double>(dof + 1));
    return state;
  }

  [[nodiscard]] double largest_displacement(double step_size, int steps) const {
    State state = disturbed();
    CentralDifference dynamics(body, tiles, moduli, 1);
    for (int i = 0; i < steps; ++i) dynamics.advance(state, {step_size, 0, 1, 0});
    double largest = 0;
    for (const double u : state.displacement)
      largest = std::isfinite(u) ? std::max(largest, std::abs(u)) : HUGE_VAL;
    return largest;
  }

  // Power iteration with the element loop itself: a step of size 1 from rest turns u into v = - M^-1 K u.
  [[nodiscard]] double exact_frequency_squared() const {
    State state = disturbed();
    state.displacement = state.velocity;
    CentralDifference dynamics(body, tiles, moduli, 1);
    double squared = 0;
    for (int i = 0; i < 4000; ++i) {
      double norm = 0;
      for (const double u : state.displacement) norm = std::max(norm, std::abs(u));
      for (double& u : state.displacement) u /= norm;
      std::fill(state.velocity.begin(), state.velocity.end(), 0.0);
      dynamics.advance(state, {1, 0, 1, 0});
      squared = 0;
      for (const double v : state.velocity) squared = std::max(squared, std::abs(v));
      state.displacement = state.velocity;
    }
    return squared;
  }
};

}  // namespace

TEST_CASE("stable step of single triangles with edges of half a metre", "[structure][dynamics]") {
  const auto moduli = elasticity(32e9, 0.2);
  const double height = 0.5 * std::sqrt(3.0) / 2, obtuse_height = 0.25 / std::sqrt(3.0);
  const auto step = [&](const Mesh& mesh) {
    const double corner_mass = 2600 * triangle(mesh, 0).area / 3;
    const std::array<double, 3> masses{corner_mass, corner_mass, corner_mass};
    const double squared = element_frequency_squared(triangle(mesh, 0), moduli, masses);
    CHECK(stiffest_element(mesh, moduli, 2600).frequency_squared == Approx(squared).epsilon(1e-12));
    return 2 / std::sqrt(squared);
  };
  const double digits = 6e-8;  // of the values below, [s]
  CHECK(step(single_triangle({0, 0}, {0.5, 0}, {0.25, height})) == Approx(9.87e-5).margin(digits));
  CHECK(step(single_triangle({0, 0}, {0.5, 0}, {0, 0.5})) == Approx(8.88e-5).margin(digits));
  CHECK(step(single_triangle({0, 0}, {0.5, 0}, {0.25, obtuse_height})) == Approx(3.67e-5).margin(digits));
}

TEST_CASE("stable step: the bound of the elements is safe and close", "[structure][dynamics]") {
  const FreeBody free;
  const auto stiffest = stiffest_element(free.mesh, free.moduli, free.settings.rock.density);
  const double bound = stable_step(stiffest.frequency_squared, 0, {1, 1, 0});
  const double exact = 2 / std::sqrt(free.exact_frequency_squared());
  CHECK(bound <= exact);
  CHECK(bound > 0.8 * exact);
  const double amplitude = free.largest_displacement(0.98 * bound, 1000);
  CHECK(free.largest_displacement(0.98 * bound, 10000) <
        50 * amplitude);  // drift of the free body is linear in time
  CHECK(free.largest_displacement(1.05 * exact, 1000) > 1e6 * amplitude);
}

TEST_CASE("stable step: names the smallest of the elements", "[structure][dynamics]") {
  Mesh mesh;
  mesh.position = {{0, 0}, {1, 0}, {0, 1}, {5, 5}, {5.3, 5}, {5, 5.3}, {9, 0}, {10, 0}, {9, 1}};
  mesh.elements = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  const auto stiffest = stiffest_element(mesh, elasticity(32e9, 0.2), 2500);
  CHECK(stiffest.element == 1);
  CHECK(stiffest.position == centroid(mesh, 1));
}

TEST_CASE("stable step: an element turned inside out is reported with its place", "[structure][dynamics]") {
  const Mesh mesh = single_triangle({10, 5}, {10, 6}, {11, 5});
  CHECK_THROWS_AS(stiffest_element(mesh, elasticity(32e9, 0.2), 2500), SolverError);
  CHECK_THROWS_WITH(stiffest_element(mesh, elasticity(32e9, 0.2), 2500), Catch::Contains("10.3"));
}

TEST_CASE("stable step: two masses on a spring", "[structure][dynamics]") {
  const double stiffness = 8e9, mass_a = 300, mass_b = 700;
  const double squared = pair_frequency_squared(stiffness, mass_a, mass_b);
  const double reduced_mass = mass_a * mass_b / (mass_a + mass_b);
  CHECK(squared == Approx(stiffness / reduced_mass).epsilon(1e-14));
  CHECK(stable_step(0, squared, {1, 1, 0}) == Approx(2 * std::sqrt(reduced_mass / stiffness)).epsilon(1e-14));
}

TEST_CASE("stable step: scales with safety, mass scale and damping", "[structure][dynamics]") {
  const double plain = stable_step(3e9, 1e9, {1, 1, 0});
  CHECK(plain == Approx(2 / std::sqrt(4e9)).epsilon(1e-14));
  CHECK(stable_step(3e9, 1e9, {0.8, 1, 0}) == Approx(0.8 * plain).epsilon(1e-14));
  CHECK(stable_step(3e9, 1e9, {1, 100, 0}) == Approx(10 * plain).epsilon(1e-14));
  CHECK(stable_step(3e9, 1e9, {1, 1, 0.21}) == Approx(plain / 1.1).epsilon(1e-14));
}
