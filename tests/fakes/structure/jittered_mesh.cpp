// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/structure/jittered_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "structure/dynamics/triangle.hpp"

namespace fissura::structure::fakes {

namespace {

constexpr std::uint32_t hilbert_side = 1u << 15;

std::uint64_t hilbert_index(std::uint32_t x, std::uint32_t y) {
  std::uint64_t index = 0;
  for (std::uint32_t s = hilbert_side / 2; s > 0; s /= 2) {
    const std::uint32_t rx = (x & s) > 0, ry = (y & s) > 0;
    index += std::uint64_t{s} * s * ((3 * rx) ^ ry);
    if (ry == 0) {
      if (rx == 1) {
        x = hilbert_side - 1 - x;
        y = hilbert_side - 1 - y;
      }
      std::swap(x, y);
    }
  }
  return index;
}

// A generator whose numbers do not depend on the standard library.
double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

void order_along_hilbert_curve(Mesh& mesh, const Grid& grid) {
  const double extent = std::max(grid.width, grid.height);
  const auto cell = [extent](double coordinate) {
    return static_cast<std::uint32_t>((coordinate / extent + 0.5) * (hilbert_side - 1));
  };
  std::vector<std::pair<std::uint64_t, ElementIndex>> order;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const Point centre = centroid(mesh, element);
    order.emplace_back(hilbert_index(cell(centre[0]), cell(centre[1])), element);
  }
  std::sort(order.begin(), order.end());
  const auto elements = mesh.elements;
  for (std::size_t i = 0; i < order.size(); ++i) mesh.elements[i] = elements[order[i].second];
}

void renumber_nodes(Mesh& mesh, const std::vector<NodeIndex>& new_number) {
  const auto position = mesh.position;
  for (std::size_t node = 0; node < position.size(); ++node) mesh.position[new_number[node]] = position[node];
  for (auto& element : mesh.elements)
    for (auto& node : element) node = new_number[node];
  for (auto& side : mesh.side_nodes)
    for (auto& node : side) node = new_number[node];
  for (auto& vertex : mesh.vertices) vertex.node = new_number[vertex.node];
  for (auto& unit : mesh.units) {
    unit.minus = new_number[unit.minus];
    unit.plus = new_number[unit.plus];
  }
}

void number_by_first_touch(Mesh& mesh) {
  std::vector<bool> touched(mesh.position.size(), false);
  std::vector<NodeIndex> new_number(mesh.position.size());
  NodeIndex next = 0;
  for (const auto& element : mesh.elements)
    for (const NodeIndex node : element) {
      if (touched[node]) continue;
      touched[node] = true;
      new_number[node] = next++;
    }
  renumber_nodes(mesh, new_number);
}

template <class Value>
void shuffle(std::vector<Value>& values, std::mt19937_64& random) {
  for (std::size_t i = values.size(); i > 1; --i)
    std::swap(values[i - 1], values[static_cast<std::size_t>(uniform(random) * static_cast<double>(i))]);
}

void add_nodes(const Grid& grid, Mesh& mesh) {
  std::mt19937_64 random(grid.seed);
  const double dx = grid.width / grid.columns, dy = grid.height / grid.rows;
  for (int row = 0; row <= grid.rows; ++row)
    for (int column = 0; column <= grid.columns; ++column) {
      Point position{column * dx - 0.5 * grid.width, row * dy - 0.5 * grid.height};
      const auto node = static_cast<NodeIndex>(mesh.position.size());
      if (column == 0) mesh.side_nodes[0].push_back(node);
      if (column == grid.columns) mesh.side_nodes[1].push_back(node);
      if (row == 0) mesh.side_nodes[2].push_back(node);
      if (row == grid.rows) mesh.side_nodes[3].push_back(node);
      const double shift_x = grid.jitter * dx * (2 * uniform(random) - 1);
      const double shift_y = grid.jitter * dy * (2 * uniform(random) - 1);
      const bool inside = column > 0 && column < grid.columns && row > 0 && row < grid.rows;
      if (inside) position[0] += shift_x;
      if (inside && 2 * row != grid.rows) position[1] += shift_y;
      if (2 * row == grid.rows) position[1] = 0;
      mesh.position.push_back(position);
    }
}

void add_elements(const Grid& grid, Mesh& mesh) {
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const auto a = static_cast<NodeIndex>(row * (grid.columns + 1) + column), b = a + 1;
      const auto d = static_cast<NodeIndex>(a + grid.columns + 1), c = d + 1;
      if ((row + column) % 2 == 0) {
        mesh.elements.push_back({a, b, c});
        mesh.elements.push_back({a, c, d});
      } else {
        mesh.elements.push_back({a, b, d});
        mesh.elements.push_back({b, c, d});
      }
    }
}

Mesh grid_mesh(const Grid& grid) {
  Mesh mesh;
  add_nodes(grid, mesh);
  add_elements(grid, mesh);
  order_along_hilbert_curve(mesh, grid);
  return mesh;
}

}  // namespace

Mesh jittered_mesh(const Grid& grid) {
  Mesh mesh = grid_mesh(grid);
  number_by_first_touch(mesh);
  return mesh;
}

Mesh mesh_with_line(const Grid& grid, double half_length) {
  Mesh mesh = grid_mesh(grid);
  std::vector<NodeIndex> line;
  for (int column = 0; column <= grid.columns; ++column)
    line.push_back(static_cast<NodeIndex>(grid.rows / 2 * (grid.columns + 1) + column));
  const auto inside = [&](std::size_t i) { return std::abs(mesh.position[line[i]][0]) < half_length; };
  std::map<NodeIndex, NodeIndex> plus;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    if (!inside(i) && !inside(i - 1) && !inside(i + 1)) continue;
    const auto vertex = static_cast<VertexIndex>(mesh.vertices.size());
    mesh.vertices.push_back({mesh.position[line[i]], {}, line[i], {}});
    if (inside(i - 1) || (inside(i) && vertex > 0))
      add_edge(mesh, {vertex - 1, vertex, 0, mesh.position[line[i]][0] - mesh.position[line[i - 1]][0]});
    if (!inside(i)) continue;
    const double length = 0.5 * (mesh.position[line[i + 1]][0] - mesh.position[line[i - 1]][0]);
    plus[line[i]] = static_cast<NodeIndex>(mesh.position.size());
    mesh.vertices.back().units.push_back(static_cast<UnitIndex>(mesh.units.size()));
    mesh.units.push_back({line[i], plus[line[i]], {0, length}, length, vertex, 0});
    mesh.position.push_back(Point(mesh.position[line[i]]));
  }
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    if (centroid(mesh, element)[1] < 0) continue;
    for (NodeIndex& node : mesh.elements[element])
      if (const auto found = plus.find(node); found != plus.end()) node = found->second;
  }
  number_by_first_touch(mesh);
  return mesh;
}

Mesh shuffled(const Mesh& mesh, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Mesh result = mesh;
  shuffle(result.elements, random);
  std::vector<NodeIndex> new_number(mesh.position.size());
  std::iota(new_number.begin(), new_number.end(), NodeIndex{0});
  shuffle(new_number, random);
  renumber_nodes(result, new_number);
  return result;
}

}  // namespace fissura::structure::fakes
