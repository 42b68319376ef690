// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "structure/dynamics/tiles.hpp"

/// Parts from which tiles are built and rebuilt.
namespace fissura::structure {

/// Gives a tile the nodes, groups and streamed data of its elements.
class TileBuilder {
 public:
  /// All must outlive this. `shares` as in Tiles.
  TileBuilder(const Mesh& mesh, const Body& body, const std::vector<std::uint8_t>& shares);

  void build(Tile& tile);

 private:
  void number_nodes(Tile& tile);
  void fill_groups(Tile& tile) const;

  const Mesh& mesh_;
  const Body& body_;
  const std::vector<std::uint8_t>& shares_;
  std::vector<std::uint16_t> local_;  // node of the mesh -> of the tile, valid for those of the present tile
  std::vector<std::uint8_t> listed_;  // 1 while the node is in Tile::nodes, 0 between tiles
};

/// Sets the streamed in-situ state at a place of a tile.
void set_in_situ(const InSituElement& in_situ, std::size_t place, Tile& tile);

/// True if the node cannot move freely along some axis.
bool is_held(const Body& body, NodeIndex node);

/// Numbers the slots of all tiles and lists those of each shared and joint node.
void link_tiles(const std::vector<NodeIndex>& joint_nodes, Tiles& tiles);

}  // namespace fissura::structure
