// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/tiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "common/errors.hpp"

namespace fissura::structure {

namespace {

std::vector<bool> shared_nodes(const Mesh& mesh, const Body& body, const std::vector<Tile>& tiles,
                               const std::vector<NodeIndex>& joint_nodes) {
  constexpr auto untouched = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> tile_of_node(mesh.position.size(), untouched);
  std::vector<bool> shared(mesh.position.size(), false);
  for (std::size_t t = 0; t < tiles.size(); ++t)
    for (const ElementIndex element : tiles[t].elements)
      for (const NodeIndex node : mesh.elements[element]) {
        if (tile_of_node[node] == untouched) tile_of_node[node] = t;
        if (tile_of_node[node] != t) shared[node] = true;
      }
  for (const NodeIndex node : joint_nodes) shared[node] = true;
  for (NodeIndex node = 0; node < shared.size(); ++node)
    if (body.inverse_mass[node][0] == 0 || body.inverse_mass[node][1] == 0) shared[node] = true;
  return shared;
}

void number_nodes(Tile& tile, const Mesh& mesh, const Body& body, const std::vector<bool>& shared) {
  tile.nodes.clear();
  for (const ElementIndex element : tile.elements)
    tile.nodes.insert(tile.nodes.end(), mesh.elements[element].begin(), mesh.elements[element].end());
  std::sort(tile.nodes.begin(), tile.nodes.end());
  tile.nodes.erase(std::unique(tile.nodes.begin(), tile.nodes.end()), tile.nodes.end());
  const auto first_shared = std::stable_partition(tile.nodes.begin(), tile.nodes.end(),
                                                  [&shared](NodeIndex n) { return !shared[n]; });
  tile.interior.clear();
  for (auto node = tile.nodes.begin(); node != first_shared; ++node)
    tile.interior.push_back(
        {body.inverse_mass[*node][0], {body.external_force[2 * *node], body.external_force[2 * *node + 1]}});
  tile.position.clear();
  for (const NodeIndex node : tile.nodes) tile.position.push_back(mesh.position[node]);
}

void fill_groups(Tile& tile, const Mesh& mesh, const Body& body) {
  ENSURE(tile.nodes.size() + padding_corners.size() <= std::numeric_limits<std::uint16_t>::max());
  std::unordered_map<NodeIndex, std::uint16_t> local;
  for (std::size_t i = 0; i < tile.nodes.size(); ++i)
    local.emplace(tile.nodes[i], static_cast<std::uint16_t>(i));
  tile.groups.assign((tile.elements.size() + group_width - 1) / group_width, ElementGroup{});
  for (std::size_t place = 0; place < tile.groups.size() * group_width; ++place) {
    ElementGroup& group = tile.groups[place / group_width];
    const std::size_t lane = place % group_width;
    if (place >= tile.elements.size()) {
      for (std::size_t corner = 0; corner < 3; ++corner)
        group.node[corner][lane] = static_cast<std::uint16_t>(tile.nodes.size() + corner);
      continue;
    }
    const ElementIndex element = tile.elements[place];
    const InSituElement& in_situ = body.in_situ[element];
    for (int corner = 0; corner < 3; ++corner)
      group.node[corner][lane] = local.at(mesh.elements[element][corner]);
    group.stress[0][lane] = in_situ.xx;
    group.stress[1][lane] = in_situ.yy;
    group.stress[2][lane] = in_situ.xy;
    group.pore_pressure[lane] = in_situ.pore_pressure;
  }
}

bool classes_changed(const Tile& tile, const std::vector<bool>& shared) {
  for (std::size_t i = 0; i < tile.nodes.size(); ++i)
    if (shared[tile.nodes[i]] != (i >= tile.interior.size())) return true;
  return false;
}

NodeSlots collect_slots(const std::vector<Tile>& tiles, const std::vector<NodeIndex>& nodes) {
  std::unordered_map<NodeIndex, std::uint32_t> place;
  for (const NodeIndex node : nodes) place.emplace(node, static_cast<std::uint32_t>(place.size()));
  ENSURE(place.size() == nodes.size());
  std::vector<std::vector<std::uint32_t>> rows(nodes.size());
  for (const Tile& tile : tiles)
    for (std::size_t i = 0; i < tile.shared_nodes(); ++i)
      if (const auto found = place.find(tile.nodes[tile.interior.size() + i]); found != place.end())
        rows[found->second].push_back(static_cast<std::uint32_t>(tile.first_slot + i));
  NodeSlots slots{nodes, {0}, {}};
  for (const auto& row : rows) {
    slots.slot.insert(slots.slot.end(), row.begin(), row.end());
    slots.first.push_back(static_cast<std::uint32_t>(slots.slot.size()));
  }
  return slots;
}

void link_tiles(Tiles& tiles, std::vector<bool> shared, const std::vector<NodeIndex>& joint_nodes) {
  tiles.slots = 0;
  for (Tile& tile : tiles.tile) {
    tile.first_slot = tiles.slots;
    tiles.slots += tile.shared_nodes();
  }
  for (const NodeIndex node : joint_nodes) shared[node] = false;
  std::vector<NodeIndex> shared_only;
  for (NodeIndex node = 0; node < shared.size(); ++node)
    if (shared[node]) shared_only.push_back(node);
  tiles.shared = collect_slots(tiles.tile, shared_only);
  tiles.joint = collect_slots(tiles.tile, joint_nodes);
}

void build_tile(Tile& tile, const Mesh& mesh, const Body& body, const std::vector<bool>& shared) {
  number_nodes(tile, mesh, body, shared);
  fill_groups(tile, mesh, body);
}

}  // namespace

Tiles build_tiles(const Mesh& mesh, const Body& body, const std::vector<NodeIndex>& joint_nodes) {
  Tiles tiles;
  for (std::size_t begin = 0; begin < mesh.elements.size(); begin += elements_per_tile) {
    const std::size_t end = std::min(begin + elements_per_tile, mesh.elements.size());
    Tile& tile = tiles.tile.emplace_back();
    const std::size_t groups = (end - begin + group_width - 1) / group_width;
    for (std::size_t group = 0; group < groups; ++group)
      for (std::size_t element = begin + group; element < end; element += groups)
        tile.elements.push_back(static_cast<ElementIndex>(element));
  }
  const auto shared = shared_nodes(mesh, body, tiles.tile, joint_nodes);
  for (Tile& tile : tiles.tile) build_tile(tile, mesh, body, shared);
  link_tiles(tiles, shared, joint_nodes);
  return tiles;
}

void rebuild_tiles(Tiles& tiles, const Mesh& mesh, const Body& body,
                   const std::vector<NodeIndex>& joint_nodes, const std::vector<std::size_t>& touched) {
  const auto shared = shared_nodes(mesh, body, tiles.tile, joint_nodes);
  std::vector<bool> stale(tiles.tile.size(), false);
  for (const std::size_t t : touched) stale[t] = true;
  for (std::size_t t = 0; t < tiles.tile.size(); ++t)
    if (stale[t] || classes_changed(tiles.tile[t], shared)) build_tile(tiles.tile[t], mesh, body, shared);
  link_tiles(tiles, shared, joint_nodes);
}

double longest_edge(const Tiles& tiles) {
  double longest = 0;
  for (const Tile& tile : tiles.tile)
    for (std::size_t place = 0; place < tile.elements.size(); ++place) {
      const ElementGroup& group = tile.groups[place / group_width];
      for (int corner = 0; corner < 3; ++corner) {
        const Point& p = tile.position[group.node[corner][place % group_width]];
        const Point& q = tile.position[group.node[(corner + 1) % 3][place % group_width]];
        longest = std::max(longest, std::hypot(q[0] - p[0], q[1] - p[1]));
      }
    }
  return longest;
}

double streamed_bytes_per_element(const Tiles& tiles) {
  constexpr std::size_t vector = 2 * sizeof(double);
  constexpr std::size_t copied = sizeof(NodeIndex) + sizeof(Point) + vector;  // displacement read
  constexpr std::size_t moved = vector + 2 * vector + sizeof(InteriorNode);   // u written, v read and written
  constexpr std::size_t slot = vector + vector + sizeof(std::uint32_t);       // force written and read
  constexpr std::size_t shared = sizeof(NodeIndex) + 2 * vector + 2 * vector + 2 * vector;
  std::size_t bytes = slot * tiles.slots + shared * tiles.shared.node.size(), elements = 0;
  for (const Tile& tile : tiles.tile) {
    bytes += sizeof(ElementGroup) * tile.groups.size() +
             tile.groups.size() * group_width;  // one failure mark each
    bytes += copied * tile.nodes.size() + moved * tile.interior.size();
    elements += tile.elements.size();
  }
  return static_cast<double>(bytes) / static_cast<double>(elements);
}

}  // namespace fissura::structure
