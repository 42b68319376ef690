// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "structure/dynamics/body.hpp"
#include "structure/mesh/mesh.hpp"
#include "structure/mesh/mesh_change.hpp"
#include "structure/mesh/node_elements.hpp"

/// The mesh cut into tiles of consecutive elements: the unit of work, of load balance and of rebuilding.
///
/// A node is interior to a tile if no other tile and no joint touches it; the tile alone moves it. Every
/// other node is shared: each tile that touches it owns one slot for its part of the force, and whoever moves
/// the node adds up its slots in ascending order. So the result does not depend on who computes which tile
/// when.
namespace fissura::structure {

constexpr std::size_t elements_per_tile = 2048;

/// Elements are computed in groups of this many.
constexpr std::size_t group_width = 8;

/// Streamed data of a group of elements; lane by lane for vector loads.
struct ElementGroup {
  std::uint16_t node[3][group_width];  ///< tile-local, counter-clockwise
  float stress[3][group_width];        ///< in-situ effective xx, yy, xy [Pa]
  float pore_pressure[group_width];    ///< Biot coefficient times pore pressure [Pa]
};

/// What a tile needs to move one of its interior nodes.
struct InteriorNode {
  double inverse_mass;                   ///< [m/kg]
  std::array<double, 2> external_force;  ///< [N/m]
};

struct Tile {
  std::vector<ElementIndex>
      elements;  ///< element of the mesh at each place; the last group is filled up with
                 ///< stressless elements on three nodes of their own, see `padding_corners`
  std::vector<ElementGroup> groups;
  std::vector<float> out_of_plane;  ///< in-situ effective sigma_zz of each place, padded like the groups;
                                    ///< only Mohr-Coulomb reads it [Pa]
  std::vector<NodeIndex> nodes;  ///< of the mesh, by tile-local number: interior ones first, then shared ones
  std::vector<Point> position;   ///< of each of `nodes` [m]
  std::vector<InteriorNode> interior;  ///< of the first of `nodes`
  std::size_t first_slot = 0;          ///< slot of its first shared node; the others follow

  [[nodiscard]] std::size_t shared_nodes() const { return nodes.size() - interior.size(); }
};

/// Corners of the elements that fill up the last group. Their tile-local numbers follow those of the tile's
/// nodes.
constexpr std::array<Point, 3> padding_corners{{{0, 0}, {1, 0}, {0, 1}}};

/// Nodes and, in compressed rows, the slots that hold the parts of their forces.
struct NodeSlots {
  std::vector<NodeIndex> node;
  std::vector<std::uint32_t> first;  ///< row of node i: slots `first[i]` to `first[i + 1]` of `slot`
  std::vector<std::uint32_t> slot;
};

struct Tiles {
  std::vector<Tile> tile;
  NodeSlots shared;  ///< nodes of several tiles and held nodes, but for joint nodes; ascending
  NodeSlots joint;   ///< the joint nodes, in the order given
  std::size_t slots = 0;
  std::vector<std::uint32_t> tile_of_element;
  std::vector<std::uint8_t> shares;  ///< of each node of the mesh: 1 if no tile alone moves it
};

/// Cuts the elements into tiles of consecutive ones. `joint_nodes` are moved by the joints, not by the
/// element loop.
Tiles build_tiles(const Mesh& mesh, const Body& body, const std::vector<NodeIndex>& joint_nodes);

/// The same with given elements in each tile, in this order: tiles that followed changes of the mesh go on
/// with the same sums.
Tiles build_tiles_of(std::vector<std::vector<ElementIndex>> elements, const Mesh& mesh, const Body& body,
                     const std::vector<NodeIndex>& joint_nodes);

/// After the mesh changed: elements made in one patch join the tile with the most elements around them, in
/// the places of removed ones as far as there are; a tile of more than twice `elements_per_tile` is cut in
/// two. Tiles without a change keep their elements and nodes. The others have followed the change before.
void update_tiles(const Mesh& mesh, const NodeElements& elements, const Body& body,
                  const std::vector<NodeIndex>& joint_nodes, const MeshChange& change, Tiles& tiles);

/// After the in-situ state of these elements (ascending) changed in `body`: gives it to their tiles.
/// Geometry, masses and forces are not looked at.
void refresh_in_situ(const Body& body, const std::vector<ElementIndex>& elements, Tiles& tiles);

/// Longest edge of an element [m].
double longest_edge(const Tiles& tiles);

/// Bytes that a step without failure reads and writes per element, counted from the data structures.
double streamed_bytes_per_element(const Tiles& tiles);

}  // namespace fissura::structure
