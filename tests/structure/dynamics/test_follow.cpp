// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <map>
#include <numeric>

#include "structure/dynamics/central_difference.hpp"
#include "structure/dynamics/frequency_bound.hpp"
#include "structure/dynamics/untouched_hash.hpp"
#include "tests/fakes/structure/jittered_mesh.hpp"
#include "tests/fakes/structure/mesh_changes.hpp"
#include "tests/fakes/structure/shale_case.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

const Grid grid{60, 50, 60, 50, 0.2, 3};

Case settings() {
  Case settings = stressed_shale_case();
  settings.boundary.west.kind = BoundaryKind::roller;
  settings.boundary.south = {BoundaryKind::displacement, {0, 1e-3}, 1};
  return settings;
}

/// What is built from a mesh, and follows it.
struct Follower {
  Case run_case = settings();
  Elasticity moduli = elasticity(run_case.rock);
  Mesh mesh = jittered_mesh(grid);
  NodeElements elements{mesh};
  Body body = build_body(mesh, run_case);
  Tiles tiles = build_tiles(mesh, body, {});
  FrequencyBound bound = bound_frequencies(mesh, moduli, run_case.rock.density);

  void follow(const MeshChange& change) {
    elements.follow(mesh, change);
    update_body(mesh, elements, run_case, change, body);
    update_tiles(mesh, elements, body, joint_nodes(mesh), change, tiles);
    update_frequencies(mesh, elements, moduli, run_case.rock.density, change, bound);
  }
};

std::vector<MeshChange> several_changes(Follower& follower) {
  std::vector<MeshChange> changes;
  const auto note = [&](MeshChange change) {
    follower.follow(change);
    changes.push_back(std::move(change));
  };
  note(refine(follower.mesh, {-29, -24}, 6));
  note(coarsen(follower.mesh, {5, 5}, 12));
  note(refine(follower.mesh, {10, 0}, 4));
  note(tear(follower.mesh, {0, 0}));
  note(coarsen(follower.mesh, {-20, 10}, 9));
  return changes;
}

}  // namespace

TEST_CASE("the imitated changes remove more than they make, reuse node places, move elements and tear",
          "[structure][dynamics]") {
  Follower follower;
  const auto changes = several_changes(follower);
  CHECK(changes[0].made.size() > changes[0].removed.size());
  CHECK(changes[1].made.size() < changes[1].removed.size());
  CHECK_FALSE(changes[1].moved.empty());
  CHECK(changes[2].new_nodes.front() < changes[2].nodes_before);
  CHECK_FALSE(changes[3].rewired.empty());
  CHECK_FALSE(follower.mesh.unused_nodes.empty());
}

TEST_CASE("node elements that followed changes equal those of the changed mesh", "[structure][dynamics]") {
  Follower follower;
  several_changes(follower);
  const NodeElements fresh(follower.mesh);
  for (NodeIndex node = 0; node < follower.mesh.position.size(); ++node) {
    const auto kept = follower.elements.of(node), built = fresh.of(node);
    REQUIRE(std::equal(kept.begin(), kept.end(), built.begin(), built.end()));
  }
}

// Rounding only: where elements moved in the list, the sums of nodes that are not touched keep their old
// order.
TEST_CASE("a body that followed changes equals one built on the changed mesh to 1e-14",
          "[structure][dynamics]") {
  Follower follower;
  several_changes(follower);
  const Body fresh = build_body(follower.mesh, follower.run_case);
  const Body& body = follower.body;
  REQUIRE(body.mass.size() == fresh.mass.size());
  const double force_scale = 25e6;  // in-situ stress times edge length [N/m]
  for (std::size_t n = 0; n < fresh.mass.size(); ++n) {
    REQUIRE(std::abs(body.mass[n] - fresh.mass[n]) <= 1e-14 * fresh.mass[n]);
    for (int axis = 0; axis < 2; ++axis) {
      REQUIRE(std::abs(body.inverse_mass[n][axis] - fresh.inverse_mass[n][axis]) <=
              1e-14 * fresh.inverse_mass[n][axis]);
      REQUIRE(std::abs(body.external_force[2 * n + axis] - fresh.external_force[2 * n + axis]) <=
              1e-14 * force_scale);
    }
  }
  CHECK(std::memcmp(body.in_situ.data(), fresh.in_situ.data(),
                    fresh.in_situ.size() * sizeof(InSituElement)) == 0);
  REQUIRE(body.prescribed.size() == fresh.prescribed.size());
  for (std::size_t i = 0; i < fresh.prescribed.size(); ++i)
    CHECK(body.prescribed[i].node == fresh.prescribed[i].node);
  CHECK(std::accumulate(body.mass.begin(), body.mass.end(), 0.0) == Approx(2500 * 60 * 50).epsilon(1e-14));
}

TEST_CASE("nodes that a change does not touch keep the bits of their mass and force",
          "[structure][dynamics]") {
  Follower follower;
  several_changes(follower);
  const Body before = follower.body;
  const MeshChange change = coarsen(follower.mesh, {15, -12}, 6);
  REQUIRE_FALSE(change.moved.empty());
  follower.follow(change);
  const auto touched = changed_nodes(change);
  for (NodeIndex node = 0; node < before.mass.size(); ++node) {
    if (std::binary_search(touched.begin(), touched.end(), node)) continue;
    REQUIRE(follower.body.mass[node] == before.mass[node]);
    REQUIRE(follower.body.external_force[2 * node] == before.external_force[2 * node]);
    REQUIRE(follower.body.external_force[2 * node + 1] == before.external_force[2 * node + 1]);
  }
}

TEST_CASE("a place without a node carries nothing", "[structure][dynamics]") {
  Follower follower;
  several_changes(follower);
  REQUIRE_FALSE(follower.mesh.unused_nodes.empty());
  for (const NodeIndex node : follower.mesh.unused_nodes) {
    CHECK(follower.body.mass[node] == 0);
    CHECK(follower.body.inverse_mass[node] == std::array<double, 2>{0, 0});
    CHECK(follower.body.external_force[2 * node] == 0);
  }
}

TEST_CASE("tiles that followed changes hold every element once and move every used node once",
          "[structure][dynamics]") {
  Follower follower;
  several_changes(follower);
  const Mesh& mesh = follower.mesh;
  const Tiles& tiles = follower.tiles;
  std::vector<int> holders(mesh.elements.size(), 0);
  std::map<NodeIndex, int> owners;
  for (std::uint32_t t = 0; t < tiles.tile.size(); ++t) {
    for (const ElementIndex element : tiles.tile[t].elements) {
      REQUIRE(element < holders.size());
      ++holders[element];
      CHECK(tiles.tile_of_element[element] == t);
    }
    for (std::size_t i = 0; i < tiles.tile[t].interior.size(); ++i) ++owners[tiles.tile[t].nodes[i]];
  }
  CHECK(std::all_of(holders.begin(), holders.end(), [](int count) { return count == 1; }));
  for (const NodeIndex node : tiles.shared.node) ++owners[node];
  for (const NodeIndex node : tiles.joint.node) ++owners[node];
  CHECK(owners.size() == mesh.position.size() - mesh.unused_nodes.size());
  for (const auto& [node, count] : owners) REQUIRE(count == 1);
}

TEST_CASE("tiles that followed changes move the rock as tiles built anew do", "[structure][dynamics]") {
  Follower follower;
  several_changes(follower);
  const Mesh& mesh = follower.mesh;
  State state = state_at_rest(follower.body);
  for (std::size_t n = 0; n < mesh.position.size(); ++n)
    state.velocity[2 * n] = 0.03 * std::sin(0.2 * mesh.position[n][0]) * std::cos(0.3 * mesh.position[n][1]);
  State fresh_state = state;
  const Body fresh_body = build_body(mesh, follower.run_case);
  const Tiles fresh_tiles = build_tiles(mesh, fresh_body, joint_nodes(mesh));
  CentralDifference kept(follower.body, follower.tiles, follower.moduli, 1);
  CentralDifference fresh(fresh_body, fresh_tiles, follower.moduli, 1);
  Step step{stable_step(stiffest_element(mesh, follower.bound).frequency_squared, 0, {0.8, 1, 0}), 0, 1, 0};
  for (int k = 0; k < 20; ++k, step.end += step.size) {
    kept.advance(state, step);
    fresh.advance(fresh_state, step);
  }
  const double scale = *std::max_element(fresh_state.velocity.begin(), fresh_state.velocity.end());
  for (std::size_t dof = 0; dof < state.velocity.size(); ++dof)
    REQUIRE(std::abs(state.velocity[dof] - fresh_state.velocity[dof]) <= 1e-10 * scale);  // rounding of sums
}

TEST_CASE("a tile that has grown beyond twice its size is cut in two", "[structure][dynamics]") {
  Follower follower;
  const std::size_t before = follower.tiles.tile.size();
  for (int k = 0; k < 3; ++k) follower.follow(refine(follower.mesh, {-10, 0}, 8));
  CHECK(follower.mesh.elements.size() > 4 * elements_per_tile);
  CHECK(follower.tiles.tile.size() > before);
  for (const Tile& tile : follower.tiles.tile) CHECK(tile.elements.size() <= 2 * elements_per_tile);
}

TEST_CASE("the bound that followed changes holds, and is hardly above that of the changed mesh",
          "[structure][dynamics]") {
  Follower follower;
  several_changes(follower);
  const double density = follower.run_case.rock.density;
  std::vector<double> sum(follower.mesh.position.size(), 0);
  for (ElementIndex element = 0; element < follower.mesh.elements.size(); ++element) {
    std::array<double, 3> mass{};
    for (int i = 0; i < 3; ++i) {
      const NodeIndex node = follower.mesh.elements[element][i];
      sum[node] += follower.bound.share[element][i];
      mass[i] = follower.bound.share[element][i] * follower.body.mass[node];
    }
    REQUIRE(element_frequency_squared(triangle(follower.mesh, element), follower.moduli, mass) <=
            follower.bound.squared[element] * (1 + 1e-12));
  }
  for (NodeIndex node = 0; node < sum.size(); ++node)
    if (!follower.elements.of(node).empty()) REQUIRE(std::abs(sum[node] - 1) < 1e-12);
  const double kept = stiffest_element(follower.mesh, follower.bound).frequency_squared;
  const double fresh = stiffest_element(follower.mesh, follower.moduli, density).frequency_squared;
  CHECK(std::sqrt(fresh / kept) > 0.97);  // the step it allows, relative to that of a bound built anew
  CHECK(std::sqrt(fresh / kept) < 1.1);
}

TEST_CASE("the hash of the untouched rest is the same before and after a change, and sees any other bit",
          "[structure][dynamics]") {
  Follower follower;
  several_changes(follower);
  const Mesh mesh_before = follower.mesh;
  const Body body_before = follower.body;
  std::vector<double> u(2 * mesh_before.position.size()), v(u.size());
  for (std::size_t dof = 0; dof < u.size(); ++dof) {
    u[dof] = 1e-3 * std::sin(static_cast<double>(dof));
    v[dof] = std::cos(static_cast<double>(dof));
  }
  const MeshChange change = coarsen(follower.mesh, {15, -12}, 6);
  REQUIRE_FALSE(change.moved.empty());
  follower.follow(change);

  const std::string before =
      untouched_hash(mesh_before, body_before, u, v, {change.removed, change.unused_nodes});
  const auto after = [&] {
    return untouched_hash(follower.mesh, follower.body, u, v, {change.made, change.new_nodes});
  };
  CHECK(before.size() == 32);
  CHECK(after() == before);
  v[41] = std::nextafter(v[41], 2);
  CHECK(after() != before);
  v[41] = std::nextafter(v[41], -2);
  CHECK(after() == before);
  std::swap(follower.mesh.elements[7][0], follower.mesh.elements[7][1]);
  CHECK(after() != before);
  std::swap(follower.mesh.elements[7][0], follower.mesh.elements[7][1]);
  follower.body.in_situ[9].zz *= 2;
  CHECK(after() != before);
}
