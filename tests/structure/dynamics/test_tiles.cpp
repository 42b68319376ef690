// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <map>
#include <set>

#include "structure/dynamics/damage_state.hpp"
#include "structure/dynamics/tiles.hpp"
#include "tests/fakes/structure/jittered_mesh.hpp"
#include "tests/fakes/structure/shale_case.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

const Grid grid{60, 50, 60, 50, 0.2, 3};

bool same_tile(const Tile& a, const Tile& b) {
  const auto same_groups = [](const ElementGroup& x, const ElementGroup& y) {
    return std::memcmp(&x, &y, sizeof(x)) == 0;
  };
  return a.elements == b.elements && a.nodes == b.nodes && a.position == b.position &&
         a.first_slot == b.first_slot &&
         std::equal(a.groups.begin(), a.groups.end(), b.groups.begin(), b.groups.end(), same_groups);
}

}  // namespace

TEST_CASE("tiles: every node is moved by exactly one owner", "[structure][dynamics]") {
  const Mesh mesh = mesh_with_line(grid, 10.5);
  const auto body = build_body(mesh, shale_case());
  const auto joints = joint_nodes(mesh);
  const auto tiles = build_tiles(mesh, body, joints);
  REQUIRE(tiles.tile.size() == 3);
  std::map<NodeIndex, int> owners;
  for (const Tile& tile : tiles.tile)
    for (std::size_t i = 0; i < tile.interior.size(); ++i) ++owners[tile.nodes[i]];
  for (const NodeIndex node : tiles.shared.node) ++owners[node];
  for (const NodeIndex node : tiles.joint.node) ++owners[node];
  CHECK(owners.size() == mesh.position.size());
  for (const auto& [node, count] : owners) REQUIRE(count == 1);
  CHECK(tiles.joint.node == joints);
  CHECK(joints.size() == 2 * mesh.units.size());
}

TEST_CASE("tiles: each slot is read by one node", "[structure][dynamics]") {
  const Mesh mesh = mesh_with_line(grid, 10.5);
  const auto tiles = build_tiles(mesh, build_body(mesh, shale_case()), joint_nodes(mesh));
  std::set<std::uint32_t> read(tiles.shared.slot.begin(), tiles.shared.slot.end());
  read.insert(tiles.joint.slot.begin(), tiles.joint.slot.end());
  CHECK(tiles.shared.slot.size() + tiles.joint.slot.size() == tiles.slots);
  CHECK(read.size() == tiles.slots);
}

TEST_CASE("tiles: an elastic element streams at most 110 bytes", "[structure][dynamics]") {
  const Mesh mesh = jittered_mesh({60, 60, 100, 100, 0.2, 1});
  const auto tiles = build_tiles(mesh, build_body(mesh, shale_case()), {});
  const double bytes = streamed_bytes_per_element(tiles);
  CHECK(bytes <= 110);
  CHECK(bytes > sizeof(ElementGroup) / group_width);
}

TEST_CASE("tiles: rebuilding what an insertion touched equals building everything", "[structure][dynamics]") {
  const Mesh before = jittered_mesh(grid);
  const Case settings = shale_case();
  auto tiles = build_tiles(before, build_body(before, settings), {});

  Mesh after = before;
  const Tile& first = tiles.tile.front();
  const ElementIndex torn = first.elements[5];
  const NodeIndex old_node = after.elements[torn][1];
  const auto new_node = static_cast<NodeIndex>(after.position.size());
  after.position.push_back(Point(after.position[old_node]));
  after.elements[torn][1] = new_node;
  after.units.push_back({old_node, new_node, {0, 1}, 1, 0, 0});

  const auto body = build_body(after, settings);
  const auto joints = joint_nodes(after);
  MeshChange change;
  change.elements_before = before.elements.size();
  change.nodes_before = before.position.size();
  change.rewired = {torn};
  change.new_nodes = {new_node};
  change.touched_nodes.assign(after.elements[torn].begin(), after.elements[torn].end());
  change.touched_nodes.push_back(old_node);
  std::sort(change.touched_nodes.begin(), change.touched_nodes.end());
  update_tiles(after, NodeElements(after), body, joints, change, tiles);
  const auto expected = build_tiles(after, body, joints);
  REQUIRE(tiles.tile.size() == expected.tile.size());
  for (std::size_t t = 0; t < tiles.tile.size(); ++t) CHECK(same_tile(tiles.tile[t], expected.tile[t]));
  CHECK(tiles.shared.slot == expected.shared.slot);
  CHECK(tiles.joint.slot == expected.joint.slot);
}

TEST_CASE("damage: records survive the way through storage", "[structure][dynamics]") {
  const Mesh mesh = jittered_mesh(grid);
  const auto tiles = build_tiles(mesh, build_body(mesh, shale_case()), {});
  const std::vector<ElementDamage> records{{7, {1e-4, 0.3, 0.5, 1e6}, {}}, {5001, {2e-4, 0.6, 0.4, 9e5}, {}}};
  const auto found = damage_records(tiles, damage_from_records(tiles, records));
  REQUIRE(found.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(found[i].element == records[i].element);
    CHECK(found[i].history.damage == records[i].history.damage);
    CHECK(found[i].history.tensile_strength == records[i].history.tensile_strength);
  }
}
