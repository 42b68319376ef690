// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/geometry_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "common/byte_archive.hpp"
#include "structure/dynamics/tiles.hpp"

namespace fissura::structure {

namespace {

void require(bool holds) {
  ByteReader::require(holds);
}

void require_below(std::span<const std::uint32_t> indices, std::size_t count) {
  require(
      std::all_of(indices.begin(), indices.end(), [count](std::uint32_t index) { return index < count; }));
}

template <class Predicate>
void require_each(const auto& values, const Predicate& holds) {
  require(std::all_of(values.begin(), values.end(), holds));
}

bool finite(const Point& point) {
  return std::isfinite(point[0]) && std::isfinite(point[1]);
}

bool ascending(std::span<const std::uint32_t> indices) {
  return std::adjacent_find(indices.begin(), indices.end(), std::greater_equal<>()) == indices.end();
}

bool contains(std::span<const std::uint32_t> indices, std::uint32_t index) {
  return std::find(indices.begin(), indices.end(), index) != indices.end();
}

void require_elements(const Mesh& mesh) {
  const std::size_t nodes = mesh.position.size();
  require(!mesh.elements.empty() && mesh.elements.size() < std::numeric_limits<ElementIndex>::max() &&
          nodes < std::numeric_limits<NodeIndex>::max());
  require_each(mesh.position, finite);
  std::vector<std::uint8_t> used(nodes, 0);
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    require_below(mesh.elements[element], nodes);
    for (const NodeIndex node : mesh.elements[element]) used[node] = 1;
    require(element_area(mesh, element) > 0);
  }
  require_below(mesh.unused_nodes, nodes);
  require(ascending(mesh.unused_nodes));
  require(static_cast<std::size_t>(std::count(used.begin(), used.end(), 0)) == mesh.unused_nodes.size());
  require_each(mesh.unused_nodes, [&](NodeIndex node) { return used[node] == 0; });
  for (const auto& side : mesh.side_nodes) require_below(side, nodes);
}

void require_fractures(const Mesh& mesh) {
  const std::size_t nodes = mesh.position.size(), vertices = mesh.vertices.size(), lines = mesh.lines.size(),
                    units = mesh.units.size();
  for (const ContactUnit& unit : mesh.units)
    require(unit.minus < nodes && unit.plus < nodes && unit.vertex < vertices && unit.line < lines &&
            unit.length > 0 && std::isfinite(unit.length) && finite(unit.face));
  for (const FractureEdge& edge : mesh.edges) {
    require(edge.begin < vertices && edge.end < vertices && edge.line < lines && edge.length > 0 &&
            std::isfinite(edge.length));
    for (const UnitIndex unit : edge.unit) require(unit == no_unit || unit < units);
  }
  for (VertexIndex vertex = 0; vertex < vertices; ++vertex) {
    const FractureVertex& here = mesh.vertices[vertex];
    require(here.node < nodes && finite(here.position));
    require_below(here.units, units);
    require_below(here.edges, mesh.edges.size());
    require_each(here.units, [&](UnitIndex unit) { return mesh.units[unit].vertex == vertex; });
    require_each(here.edges, [&](EdgeIndex edge) {
      return mesh.edges[edge].begin == vertex || mesh.edges[edge].end == vertex;
    });
  }
  for (UnitIndex unit = 0; unit < units; ++unit)
    require(contains(mesh.vertices[mesh.units[unit].vertex].units, unit));
  for (EdgeIndex edge = 0; edge < mesh.edges.size(); ++edge)
    for (const VertexIndex end : {mesh.edges[edge].begin, mesh.edges[edge].end})
      require(contains(mesh.vertices[end].edges, edge));
}

}  // namespace

void require_whole(const Mesh& mesh) {
  require_elements(mesh);
  require_fractures(mesh);
}

void require_of_mesh(const Body& body, const Mesh& mesh) {
  const std::size_t nodes = mesh.position.size();
  require(body.mass.size() == nodes && body.inverse_mass.size() == nodes &&
          body.external_force.size() == 2 * nodes && body.in_situ.size() == mesh.elements.size());
  require_each(body.prescribed,
               [nodes](const PrescribedNode& prescribed) { return prescribed.node < nodes; });
}

void require_of_mesh(const FrequencyBound& bound, const Mesh& mesh) {
  require(bound.share.size() == mesh.elements.size() && bound.squared.size() == mesh.elements.size());
}

void require_all_elements(const std::vector<std::vector<ElementIndex>>& tiles, const Mesh& mesh) {
  std::vector<std::uint8_t> placed(mesh.elements.size(), 0);
  std::size_t count = 0;
  for (const std::vector<ElementIndex>& tile : tiles) {
    require(!tile.empty() && tile.size() <= 2 * elements_per_tile);
    require_below(tile, mesh.elements.size());
    for (const ElementIndex element : tile) placed[element] = 1;
    count += tile.size();
  }
  require(count == placed.size() && std::find(placed.begin(), placed.end(), 0) == placed.end());
}

}  // namespace fissura::structure
