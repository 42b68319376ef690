// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/tile_building.hpp"

#include <algorithm>
#include <limits>

#include "common/errors.hpp"

namespace fissura::structure {

namespace {

NodeSlots rows_of(const std::vector<NodeIndex>& nodes, const std::vector<std::uint32_t>& first,
                  const std::vector<std::uint32_t>& slot) {
  NodeSlots rows{nodes, {0}, {}};
  for (const NodeIndex node : nodes) {
    rows.slot.insert(rows.slot.end(), slot.begin() + first[node], slot.begin() + first[node + 1]);
    rows.first.push_back(static_cast<std::uint32_t>(rows.slot.size()));
  }
  return rows;
}

}  // namespace

TileBuilder::TileBuilder(const Mesh& mesh, const Body& body, const std::vector<std::uint8_t>& shares)
    : mesh_(mesh),
      body_(body),
      shares_(shares),
      local_(mesh.position.size(), 0),
      listed_(mesh.position.size(), 0) {}

void TileBuilder::build(Tile& tile) {
  number_nodes(tile);
  fill_groups(tile);
}

void TileBuilder::number_nodes(Tile& tile) {
  tile.nodes.clear();
  for (const ElementIndex element : tile.elements)
    for (const NodeIndex node : mesh_.elements[element]) {
      if (listed_[node]) continue;
      listed_[node] = 1;
      tile.nodes.push_back(node);
    }
  ENSURE(tile.nodes.size() + padding_corners.size() <= std::numeric_limits<std::uint16_t>::max());
  std::sort(tile.nodes.begin(), tile.nodes.end());
  const auto first_shared = std::stable_partition(tile.nodes.begin(), tile.nodes.end(),
                                                  [this](NodeIndex node) { return !shares_[node]; });
  tile.interior.clear();
  for (auto node = tile.nodes.begin(); node != first_shared; ++node)
    tile.interior.push_back({body_.inverse_mass[*node][0],
                             {body_.external_force[2 * *node], body_.external_force[2 * *node + 1]}});
  tile.position.clear();
  for (std::size_t i = 0; i < tile.nodes.size(); ++i) {
    const NodeIndex node = tile.nodes[i];
    tile.position.push_back(mesh_.position[node]);
    local_[node] = static_cast<std::uint16_t>(i);
    listed_[node] = 0;
  }
}

void TileBuilder::fill_groups(Tile& tile) const {
  tile.groups.assign((tile.elements.size() + group_width - 1) / group_width, ElementGroup{});
  tile.out_of_plane.assign(tile.groups.size() * group_width, 0);
  for (std::size_t place = 0; place < tile.groups.size() * group_width; ++place) {
    ElementGroup& group = tile.groups[place / group_width];
    const std::size_t lane = place % group_width;
    if (place >= tile.elements.size()) {
      for (std::size_t corner = 0; corner < 3; ++corner)
        group.node[corner][lane] = static_cast<std::uint16_t>(tile.nodes.size() + corner);
      continue;
    }
    const ElementIndex element = tile.elements[place];
    for (int corner = 0; corner < 3; ++corner)
      group.node[corner][lane] = local_[mesh_.elements[element][corner]];
    set_in_situ(body_.in_situ[element], place, tile);
  }
}

void set_in_situ(const InSituElement& in_situ, std::size_t place, Tile& tile) {
  ElementGroup& group = tile.groups[place / group_width];
  const std::size_t lane = place % group_width;
  group.stress[0][lane] = in_situ.xx;
  group.stress[1][lane] = in_situ.yy;
  group.stress[2][lane] = in_situ.xy;
  group.pore_pressure[lane] = in_situ.pore_pressure;
  tile.out_of_plane[place] = in_situ.zz;
}

bool is_held(const Body& body, NodeIndex node) {
  return body.inverse_mass[node][0] == 0 || body.inverse_mass[node][1] == 0;
}

void link_tiles(const std::vector<NodeIndex>& joint_nodes, Tiles& tiles) {
  const std::size_t nodes = tiles.shares.size();
  std::vector<std::uint32_t> first(nodes + 1, 0);
  tiles.slots = 0;
  for (Tile& tile : tiles.tile) {
    tile.first_slot = tiles.slots;
    tiles.slots += tile.shared_nodes();
    for (std::size_t i = tile.interior.size(); i < tile.nodes.size(); ++i) ++first[tile.nodes[i] + 1];
  }
  std::vector<NodeIndex> shared;
  auto next_joint = joint_nodes.begin();
  for (NodeIndex node = 0; node < nodes; ++node) {
    const bool is_joint = next_joint != joint_nodes.end() && *next_joint == node;
    if (is_joint) ++next_joint;
    if (first[node + 1] > 0 && !is_joint) shared.push_back(node);
    first[node + 1] += first[node];
  }
  ENSURE(next_joint == joint_nodes.end());

  std::vector<std::uint32_t> slot(tiles.slots), next(first.begin(), first.end() - 1);
  for (const Tile& tile : tiles.tile)
    for (std::size_t i = 0; i < tile.shared_nodes(); ++i)
      slot[next[tile.nodes[tile.interior.size() + i]]++] = static_cast<std::uint32_t>(tile.first_slot + i);
  tiles.shared = rows_of(shared, first, slot);
  tiles.joint = rows_of(joint_nodes, first, slot);
}

}  // namespace fissura::structure
