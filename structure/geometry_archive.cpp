// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/geometry_archive.hpp"

#include <cmath>

#include "structure/geometry_checks.hpp"
#include "structure/state_parts.hpp"

namespace fissura::structure {

namespace {

auto parts_of_mesh(auto& mesh) {
  auto& [west, east, south, north] = mesh.side_nodes;
  return std::tie(mesh.lines, mesh.position, mesh.elements, west, east, south, north, mesh.vertices,
                  mesh.edges, mesh.units, mesh.unused_nodes);
}

auto parts_of_body(auto& body) {
  return std::tie(body.mass, body.inverse_mass, body.in_situ, body.external_force, body.prescribed);
}

auto parts_of_numbers(auto& geometry) {
  return std::tie(geometry.frequency_bound.share, geometry.frequency_bound.squared,
                  geometry.frequency_squared, geometry.number);
}

template <class Parts>
void put(const Parts& parts, ByteWriter& bytes) {
  std::apply([&](const auto&... part) { (bytes.put(part), ...); }, parts);
}

template <class Parts>
void get(const Parts& parts, ByteReader& bytes) {
  std::apply([&](auto&... part) { (bytes.get(part), ...); }, parts);
}

}  // namespace

void save_geometry(const Geometry& geometry, ByteWriter& bytes) {
  put(parts_of_mesh(geometry.mesh), bytes);
  put(parts_of_body(geometry.body), bytes);
  bytes.put(std::uint64_t{geometry.tiles.tile.size()});
  for (const Tile& tile : geometry.tiles.tile) bytes.put(tile.elements);
  put(parts_of_numbers(geometry), bytes);
}

Geometry restore_geometry(ByteReader& bytes) {
  Geometry geometry;
  get(parts_of_mesh(geometry.mesh), bytes);
  require_whole(geometry.mesh);
  get(parts_of_body(geometry.body), bytes);
  require_of_mesh(geometry.body, geometry.mesh);
  std::vector<std::vector<ElementIndex>> tiles;
  bytes.get(tiles);
  require_all_elements(tiles, geometry.mesh);
  get(parts_of_numbers(geometry), bytes);
  require_of_mesh(geometry.frequency_bound, geometry.mesh);
  ByteReader::require(geometry.frequency_squared > 0 && std::isfinite(geometry.frequency_squared));
  geometry.node_elements = NodeElements(geometry.mesh);
  geometry.joint_nodes = joint_nodes(geometry.mesh);
  geometry.tiles = build_tiles_of(std::move(tiles), geometry.mesh, geometry.body, geometry.joint_nodes);
  return geometry;
}

}  // namespace fissura::structure
