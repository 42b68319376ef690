// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>

#include "mesh_cases.hpp"
#include "structure/mesh/build_mesh.hpp"
#include "structure/mesh/hilbert.hpp"

using namespace fissura;
using namespace fissura::structure;

TEST_CASE("the Hilbert curve steps from cell to neighbouring cell and visits all", "[structure][mesh]") {
  std::vector<Point> cells;
  for (int i = 0; i < 16; ++i)
    for (int j = 0; j < 16; ++j) cells.push_back({1.0 * i, 1.0 * j});
  std::vector<std::uint32_t> order = hilbert_order(cells);
  for (std::size_t i = 0; i + 1 < order.size(); ++i)
    REQUIRE(distance(cells[order[i]], cells[order[i + 1]]) == 1);
  std::sort(order.begin(), order.end());
  for (std::uint32_t i = 0; i < order.size(); ++i) REQUIRE(order[i] == i);
}

TEST_CASE("nodes are numbered by the first element that touches them", "[structure][mesh]") {
  const Mesh mesh = build_mesh(crossing());
  NodeIndex next = 0;
  for (const auto& element : mesh.elements)
    for (const NodeIndex node : element) {
      REQUIRE(node <= next);
      if (node == next) ++next;
    }
  CHECK(next == mesh.position.size());
}

TEST_CASE("consecutive elements mostly share a node", "[structure][mesh]") {
  const Mesh mesh = build_mesh(crossing());
  std::size_t sharing = 0;
  for (std::size_t e = 1; e < mesh.elements.size(); ++e)
    sharing += std::any_of(mesh.elements[e].begin(), mesh.elements[e].end(), [&](NodeIndex node) {
      const auto& before = mesh.elements[e - 1];
      return std::find(before.begin(), before.end(), node) != before.end();
    });
  // In a random order hardly any do; the curve leaves a vertex's ring only at jumps between cells.
  CHECK(static_cast<double>(sharing) > 0.8 * static_cast<double>(mesh.elements.size()));
}
