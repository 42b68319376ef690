// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/geometry_archive.hpp"

namespace fissura::structure {

namespace {

void save_line(const FractureLine& line, ByteWriter& bytes) {
  bytes.put(line.name);
  bytes.put(line.kind);
  bytes.put(line.points);
  bytes.put(line.tensile_strength);
  bytes.put(line.fracture_energy);
  bytes.put(line.friction_coefficient);
  bytes.put(line.cohesion);
  bytes.put(line.dilation_angle);
  bytes.put(line.dilation_slip);
  bytes.put(line.residual_aperture);
  bytes.put(line.joint_compliance);
  bytes.put(line.set);
}

FractureLine restore_line(ByteReader& bytes) {
  FractureLine line;
  bytes.get(line.name);
  bytes.get(line.kind);
  bytes.get(line.points);
  bytes.get(line.tensile_strength);
  bytes.get(line.fracture_energy);
  bytes.get(line.friction_coefficient);
  bytes.get(line.cohesion);
  bytes.get(line.dilation_angle);
  bytes.get(line.dilation_slip);
  bytes.get(line.residual_aperture);
  bytes.get(line.joint_compliance);
  bytes.get(line.set);
  return line;
}

std::uint64_t restore_count(ByteReader& bytes) {
  std::uint64_t count = 0;
  bytes.get(count);
  return count;
}

void save_mesh(const Mesh& mesh, ByteWriter& bytes) {
  bytes.put(std::uint64_t{mesh.lines.size()});
  for (const FractureLine& line : mesh.lines) save_line(line, bytes);
  bytes.put(mesh.position);
  bytes.put(mesh.elements);
  for (const auto& side : mesh.side_nodes) bytes.put(side);
  bytes.put(std::uint64_t{mesh.vertices.size()});
  for (const FractureVertex& vertex : mesh.vertices) {
    bytes.put(vertex.position);
    bytes.put(vertex.units);
    bytes.put(vertex.node);
    bytes.put(vertex.edges);
  }
  bytes.put(mesh.edges);
  bytes.put(mesh.units);
  bytes.put(mesh.unused_nodes);
}

Mesh restore_mesh(ByteReader& bytes) {
  Mesh mesh;
  for (std::uint64_t left = restore_count(bytes); left > 0; --left) mesh.lines.push_back(restore_line(bytes));
  bytes.get(mesh.position);
  bytes.get(mesh.elements);
  for (auto& side : mesh.side_nodes) bytes.get(side);
  for (std::uint64_t left = restore_count(bytes); left > 0; --left) {
    FractureVertex& vertex = mesh.vertices.emplace_back();
    bytes.get(vertex.position);
    bytes.get(vertex.units);
    bytes.get(vertex.node);
    bytes.get(vertex.edges);
  }
  bytes.get(mesh.edges);
  bytes.get(mesh.units);
  bytes.get(mesh.unused_nodes);
  return mesh;
}

void save_body(const Body& body, ByteWriter& bytes) {
  bytes.put(body.mass);
  bytes.put(body.inverse_mass);
  bytes.put(body.in_situ);
  bytes.put(body.external_force);
  bytes.put(body.prescribed);
}

Body restore_body(ByteReader& bytes) {
  Body body;
  bytes.get(body.mass);
  bytes.get(body.inverse_mass);
  bytes.get(body.in_situ);
  bytes.get(body.external_force);
  bytes.get(body.prescribed);
  return body;
}

std::vector<std::vector<ElementIndex>> restore_tile_elements(ByteReader& bytes) {
  std::vector<std::vector<ElementIndex>> elements;
  for (std::uint64_t left = restore_count(bytes); left > 0; --left) bytes.get(elements.emplace_back());
  return elements;
}

}  // namespace

void save_geometry(const Geometry& geometry, ByteWriter& bytes) {
  save_mesh(geometry.mesh, bytes);
  save_body(geometry.body, bytes);
  bytes.put(std::uint64_t{geometry.tiles.tile.size()});
  for (const Tile& tile : geometry.tiles.tile) bytes.put(tile.elements);
  bytes.put(geometry.frequency_bound.share);
  bytes.put(geometry.frequency_bound.squared);
  bytes.put(geometry.frequency_squared);
  bytes.put(geometry.number);
}

Geometry restore_geometry(ByteReader& bytes) {
  Geometry geometry;
  geometry.mesh = restore_mesh(bytes);
  geometry.node_elements = NodeElements(geometry.mesh);
  geometry.body = restore_body(bytes);
  geometry.joint_nodes = joint_nodes(geometry.mesh);
  geometry.tiles =
      build_tiles_of(restore_tile_elements(bytes), geometry.mesh, geometry.body, geometry.joint_nodes);
  bytes.get(geometry.frequency_bound.share);
  bytes.get(geometry.frequency_bound.squared);
  bytes.get(geometry.frequency_squared);
  bytes.get(geometry.number);
  return geometry;
}

}  // namespace fissura::structure
