// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/tiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "structure/dynamics/tile_building.hpp"

namespace fissura::structure {

namespace {

void list_tiles_of_elements(const Mesh& mesh, Tiles& tiles) {
  tiles.tile_of_element.resize(mesh.elements.size());
  for (std::uint32_t t = 0; t < tiles.tile.size(); ++t)
    for (const ElementIndex element : tiles.tile[t].elements) tiles.tile_of_element[element] = t;
}

void find_shared_nodes(const Mesh& mesh, const Body& body, const std::vector<NodeIndex>& joint_nodes,
                       Tiles& tiles) {
  constexpr auto untouched = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> tile_of_node(mesh.position.size(), untouched);
  tiles.shares.assign(mesh.position.size(), 0);
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element)
    for (const NodeIndex node : mesh.elements[element]) {
      const std::uint32_t t = tiles.tile_of_element[element];
      if (tile_of_node[node] == untouched) tile_of_node[node] = t;
      if (tile_of_node[node] != t || is_held(body, node)) tiles.shares[node] = 1;
    }
  for (const NodeIndex node : joint_nodes) tiles.shares[node] = 1;
}

}  // namespace

Tiles build_tiles(const Mesh& mesh, const Body& body, const std::vector<NodeIndex>& joint_nodes) {
  std::vector<std::vector<ElementIndex>> elements;
  for (std::size_t begin = 0; begin < mesh.elements.size(); begin += elements_per_tile) {
    const std::size_t end = std::min(begin + elements_per_tile, mesh.elements.size());
    auto& tile = elements.emplace_back();
    const std::size_t groups = (end - begin + group_width - 1) / group_width;
    for (std::size_t group = 0; group < groups; ++group)
      for (std::size_t element = begin + group; element < end; element += groups)
        tile.push_back(static_cast<ElementIndex>(element));
  }
  return build_tiles_of(std::move(elements), mesh, body, joint_nodes);
}

Tiles build_tiles_of(std::vector<std::vector<ElementIndex>> elements, const Mesh& mesh, const Body& body,
                     const std::vector<NodeIndex>& joint_nodes) {
  Tiles tiles;
  tiles.tile.resize(elements.size());
  for (std::size_t t = 0; t < elements.size(); ++t) tiles.tile[t].elements = std::move(elements[t]);
  list_tiles_of_elements(mesh, tiles);
  find_shared_nodes(mesh, body, joint_nodes, tiles);
  TileBuilder builder(mesh, body, tiles.shares);
  for (Tile& tile : tiles.tile) builder.build(tile);
  link_tiles(joint_nodes, tiles);
  return tiles;
}

void refresh_in_situ(const Body& body, const std::vector<ElementIndex>& elements, Tiles& tiles) {
  std::set<std::uint32_t> touched;
  for (const ElementIndex element : elements) touched.insert(tiles.tile_of_element[element]);
  for (const std::uint32_t t : touched)
    for (std::size_t place = 0; place < tiles.tile[t].elements.size(); ++place)
      if (std::binary_search(elements.begin(), elements.end(), tiles.tile[t].elements[place]))
        set_in_situ(body.in_situ[tiles.tile[t].elements[place]], place, tiles.tile[t]);
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
