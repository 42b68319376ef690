// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "structure/dynamics/central_difference.hpp"
#include "structure/dynamics/stable_step.hpp"
#include "tests/fakes/structure/jittered_mesh.hpp"
#include "tests/fakes/structure/naive_structure.hpp"
#include "tests/fakes/structure/shale_case.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

const Grid grid{30, 25, 61, 51, 0.25, 5};

// Tension in situ, so that the wave cracks a part of the body.
Case brittle_case() {
  Case settings = shale_case();
  settings.in_situ.stress = {0.5e6, 0.2e6, 0.1e6, 0};
  settings.rock.tensile_strength = 0.7e6;
  settings.boundary.west.kind = BoundaryKind::roller;
  settings.boundary.south.kind = BoundaryKind::fixed;
  return settings;
}

// Compression in situ close to Mohr-Coulomb.
Case shearing_case() {
  Case settings = brittle_case();
  settings.in_situ.stress = {0.2e6, -22e6, 1e6, -4e6};
  settings.bulk_failure.cohesion = 8e6;
  settings.bulk_failure.friction_angle = 0.5;
  settings.bulk_failure.dilation_angle = 0.2;
  return settings;
}

RockFailure law_of(const Case& settings) {
  return rock_failure(settings.rock, settings.bulk_failure);
}

std::vector<double> wave(const Mesh& mesh, const Body& body) {
  std::vector<double> velocity;
  for (std::size_t node = 0; node < mesh.position.size(); ++node) {
    const auto& [x, y] = mesh.position[node];
    velocity.push_back(body.inverse_mass[node][0] > 0 ? 0.12 * std::sin(0.4 * x) * std::cos(0.3 * y) : 0);
    velocity.push_back(body.inverse_mass[node][1] > 0 ? 0.10 * std::cos(0.2 * x) * std::sin(0.5 * y) : 0);
  }
  return velocity;
}

Step step_on(const Mesh& mesh, const Case& settings) {
  const auto stiffest = stiffest_element(mesh, elasticity(settings.rock), settings.rock.density);
  return {stable_step(stiffest.frequency_squared, 0, {0.6, 1, 0.1}), 0, 1, 0.1};
}

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i) result = std::max(result, std::abs(a[i] - b[i]));
  return result;
}

constexpr int steps = 20;
constexpr double summation_order = 1e-12;  // the two add forces in different orders

}  // namespace

TEST_CASE("element loop: equals one element at a time, elastic", "[structure][dynamics]") {
  const Mesh mesh = jittered_mesh(grid);
  const Case settings = brittle_case();
  const auto body = build_body(mesh, settings);
  const auto moduli = elasticity(settings.rock);
  const Step step = step_on(mesh, settings);

  const auto tiles = build_tiles(mesh, body, {});
  REQUIRE(mesh.elements.size() % group_width != 0);
  State state = state_at_rest(body);
  state.velocity = wave(mesh, body);
  CentralDifference dynamics(body, tiles, moduli, 1);
  NaiveStructure reference(mesh, body, moduli, std::nullopt);
  reference.set_velocity(state.velocity);
  for (int i = 0; i < steps; ++i) {
    dynamics.advance(state, step);
    reference.advance(step);
  }
  CHECK(largest_difference(state.velocity, reference.velocity()) < summation_order * largest(state.velocity));
  CHECK(largest_difference(state.displacement, reference.displacement()) <
        summation_order * largest(state.displacement));
}

TEST_CASE("element loop: equals one element at a time while a tenth of the body softens",
          "[structure][dynamics]") {
  const Mesh mesh = jittered_mesh(grid);
  const Case settings = brittle_case();
  const auto body = build_body(mesh, settings);
  const auto moduli = elasticity(settings.rock);
  const Step step = step_on(mesh, settings);

  const auto tiles = build_tiles(mesh, body, {});
  State state = state_at_rest(body, tiles);
  state.velocity = wave(mesh, body);
  CentralDifference dynamics(body, tiles, moduli, law_of(settings), 1);
  NaiveStructure reference(mesh, body, moduli, law_of(settings));
  reference.set_velocity(state.velocity);
  for (int i = 0; i < steps; ++i) {
    dynamics.advance(state, step);
    reference.advance(step);
  }
  const auto cracked = damage_records(tiles, state.damage).size();
  CHECK(cracked > mesh.elements.size() / 20);
  CHECK(cracked < mesh.elements.size() / 2);
  CHECK(cracked == reference.cracked_elements());
  CHECK(largest_difference(state.velocity, reference.velocity()) < summation_order * largest(state.velocity));
}

TEST_CASE("element loop: equals one element at a time while rock shears and cracks",
          "[structure][dynamics]") {
  const Mesh mesh = jittered_mesh(grid);
  const Case settings = shearing_case();
  const auto body = build_body(mesh, settings);
  const auto moduli = elasticity(settings.rock);
  const Step step = step_on(mesh, settings);

  const auto tiles = build_tiles(mesh, body, {});
  State state = state_at_rest(body, tiles);
  state.velocity = wave(mesh, body);
  for (double& component : state.velocity) component *= 8;
  CentralDifference dynamics(body, tiles, moduli, law_of(settings), 1);
  NaiveStructure reference(mesh, body, moduli, law_of(settings));
  reference.set_velocity(state.velocity);
  for (int i = 0; i < steps; ++i) {
    dynamics.advance(state, step);
    reference.advance(step);
  }
  std::size_t sheared = 0, cracked = 0;
  const auto records = damage_records(tiles, state.damage);
  for (const ElementDamage& record : records) {
    sheared += record.plastic.work > 0;
    cracked += record.history.damage > 0 && record.plastic.work == 0;
  }
  CAPTURE(sheared, cracked, mesh.elements.size());
  CHECK(sheared > mesh.elements.size() / 50);
  CHECK(cracked > mesh.elements.size() / 50);
  CHECK(records.size() < mesh.elements.size() / 2);
  CHECK(records.size() == reference.cracked_elements());
  CHECK(largest_difference(state.velocity, reference.velocity()) < summation_order * largest(state.velocity));
}

TEST_CASE("element loop: failure starts in no element in which it is forbidden, and goes on where it started",
          "[structure][dynamics]") {
  const Mesh mesh = jittered_mesh(grid);
  const Case settings = brittle_case();
  const auto body = build_body(mesh, settings);
  const auto tiles = build_tiles(mesh, body, {});
  const Step step = step_on(mesh, settings);
  State state = state_at_rest(body, tiles);
  state.velocity = wave(mesh, body);
  CentralDifference dynamics(body, tiles, elasticity(settings.rock), law_of(settings), 1);
  std::vector<ElementIndex> every(mesh.elements.size());
  std::iota(every.begin(), every.end(), 0);

  forbid_onset(tiles, every, state.damage);
  for (int i = 0; i < steps / 2; ++i) dynamics.advance(state, step);
  CHECK(damage_records(tiles, state.damage).empty());

  forbid_onset(tiles, {}, state.damage);
  for (int i = 0; i < steps / 2; ++i) dynamics.advance(state, step);
  const auto started = damage_records(tiles, state.damage);
  REQUIRE(started.size() > mesh.elements.size() / 20);

  forbid_onset(tiles, every, state.damage);
  for (int i = 0; i < steps; ++i) dynamics.advance(state, step);
  const auto later = damage_records(tiles, state.damage);
  REQUIRE(later.size() == started.size());
  double before = 0, after = 0;
  for (std::size_t i = 0; i < later.size(); ++i) {
    CHECK(later[i].element == started[i].element);
    before += started[i].history.damage;
    after += later[i].history.damage;
  }
  CHECK(after > 1.01 * before);
}

TEST_CASE("element loop: without a law for failure nothing cracks", "[structure][dynamics]") {
  const Mesh mesh = jittered_mesh(grid);
  const Case settings = brittle_case();
  const auto body = build_body(mesh, settings);
  const auto tiles = build_tiles(mesh, body, {});
  const Step step = step_on(mesh, settings);
  Case strong = settings;
  strong.rock.tensile_strength = 1e12;
  strong.rock.fracture_energy = 1e12;

  State elastic = state_at_rest(body), intact = state_at_rest(body, tiles);
  elastic.velocity = intact.velocity = wave(mesh, body);
  CentralDifference without(body, tiles, elasticity(settings.rock), 1);
  CentralDifference with(body, tiles, elasticity(settings.rock), law_of(strong), 1);
  for (int i = 0; i < steps; ++i) {
    without.advance(elastic, step);
    with.advance(intact, step);
  }
  CHECK(elastic.displacement == intact.displacement);
  CHECK(elastic.velocity == intact.velocity);
}

TEST_CASE("element loop: the same bits for 1, 2, 3 and 4 threads while elements soften",
          "[structure][dynamics]") {
  const Mesh mesh = mesh_with_line({40, 40, 80, 80, 0.25, 9}, 6.1);
  const Case settings = brittle_case();
  const auto body = build_body(mesh, settings);
  const auto tiles = build_tiles(mesh, body, joint_nodes(mesh));
  REQUIRE(tiles.tile.size() >= 4);
  const Step step = step_on(mesh, settings);
  const auto run = [&](int threads) {
    State state = state_at_rest(body, tiles);
    state.velocity = wave(mesh, body);
    CentralDifference dynamics(body, tiles, elasticity(settings.rock), law_of(settings), threads);
    for (int i = 0; i < 30; ++i) dynamics.advance(state, step);
    REQUIRE(damage_records(tiles, state.damage).size() > mesh.elements.size() / 20);
    return std::tuple{state.displacement, state.velocity, dynamics.joint_force()};
  };
  const auto one = run(1);
  for (const int threads : {2, 3, 4}) CHECK(run(threads) == one);
}
