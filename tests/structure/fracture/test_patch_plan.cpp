// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/structure/fracture/growing_rock.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

/// A line planned in its patch.
struct Planned {
  PatchPlan plan;
  std::size_t nodes_before = 0;

  [[nodiscard]] std::size_t made(PlannedNode::Origin origin) const {
    return static_cast<std::size_t>(
        std::count_if(plan.nodes.begin(), plan.nodes.end(),
                      [origin](const PlannedNode& node) { return node.origin == origin; }));
  }
  [[nodiscard]] std::vector<PlannedUnit> units_of(VertexIndex vertex) const {
    std::vector<PlannedUnit> units;
    std::copy_if(plan.units.begin(), plan.units.end(), std::back_inserter(units),
                 [vertex](const PlannedUnit& unit) { return unit.vertex == vertex; });
    return units;
  }
};

Planned plan_line(const GrowingRock& rock, NodeIndex start, const std::vector<LineVertex>& line) {
  const Mesh& mesh = rock.geometry.mesh;
  const PatchChoice choice = choose_patch(
      mesh, rock.geometry.node_elements, rock.model.run_case.mesh,
      {start, line.front().position, line.back().position, 2.2 * rock.h()}, CoarseElements::refined);
  const PatchOutline around = outline(mesh, choice.elements, fracture_nodes(mesh));
  std::vector<Point> points;
  for (const LineVertex& vertex : line) points.push_back(vertex.position);
  const auto patch = mesh_patch(around, points, choice.field, 0.2 * rock.h());
  REQUIRE(patch);
  return {plan_patch({mesh, rock.geometry.node_elements, mesh.vertices.size(), 0}, line, choice.elements,
                     around, *patch),
          mesh.position.size()};
}

Planned plan_from_tip(const GrowingRock& rock, const FractureTip& tip,
                      const std::vector<LineVertex>& beyond) {
  std::vector<LineVertex> line{{tip.position, tip.vertex}};
  line.insert(line.end(), beyond.begin(), beyond.end());
  return plan_line(rock, tip.node, line);
}

double sum_of_lengths(const std::vector<PlannedUnit>& units) {
  double sum = 0;
  for (const PlannedUnit& unit : units) sum += unit.length;
  return sum;
}

}  // namespace

TEST_CASE("a segment splits the old tip in two and leaves the new one whole", "[structure][fracture]") {
  const GrowingRock rock(free_slit());
  const FractureTip tip = rock.tip_near({2.5, 0});
  const double turn = GENERATE(0.0, 0.5, -1.2);
  const Point end{tip.position[0] + 0.25 * std::cos(turn), 0.25 * std::sin(turn)};
  const Planned planned = plan_from_tip(rock, tip, {{end, std::nullopt}});
  const PatchPlan& plan = planned.plan;
  const auto vertices = static_cast<VertexIndex>(rock.geometry.mesh.vertices.size());

  CHECK(planned.made(PlannedNode::Origin::copy) == 1);
  REQUIRE(plan.new_vertices.size() == 1);
  CHECK(plan.new_vertices[0].position == end);
  REQUIRE(plan.new_edges.size() == 1);
  CHECK(plan.new_edges[0].begin == tip.vertex);
  CHECK(plan.new_edges[0].end == vertices);
  CHECK(plan.new_edges[0].length == Approx(0.25).epsilon(1e-12));
  CHECK(plan.split == std::vector<VertexIndex>{tip.vertex});
  CHECK(plan.tip == end);

  // Halves of the old and of the new edge. Nothing of an older unit is in it.
  REQUIRE(plan.units.size() == 1);
  const PlannedUnit& unit = plan.units[0];
  const double old_half =
      std::hypot(tip.position[0] - rock.geometry.mesh.vertices[tip.previous].position[0], 0.0) / 2;
  CHECK(unit.length == Approx(old_half + 0.125).epsilon(1e-12));
  CHECK(std::abs(unit.face[1]) == Approx(old_half + 0.125 * std::cos(turn)).epsilon(1e-12));
  CHECK(unit.face[0] * std::copysign(1.0, unit.face[1]) == Approx(-0.125 * std::sin(turn)).margin(1e-12));
  CHECK_FALSE(unit.same);
  CHECK_FALSE(unit.source);
  // One of the two sides keeps the node; the other is its copy, at the same place.
  const PlannedNodeIndex kept = std::min(unit.minus, unit.plus), copied = std::max(unit.minus, unit.plus);
  CHECK(kept == tip.node);
  REQUIRE(copied >= planned.nodes_before);
  CHECK(plan.nodes[copied - planned.nodes_before].source == tip.node);
  CHECK(plan.nodes[copied - planned.nodes_before].position == tip.position);
}

TEST_CASE("the plus side of a unit is to the left of its line", "[structure][fracture]") {
  const GrowingRock rock(free_slit());
  const FractureTip tip = rock.tip_near({-2.5, 0});  // grows towards -x: its left is below
  const Planned planned = plan_from_tip(rock, tip, {{{tip.position[0] - 0.25, 0}, std::nullopt}});
  const PlannedUnit& unit = planned.plan.units.at(0);
  for (const auto& triangle : planned.plan.made) {
    double height = 0;
    for (const PlannedNodeIndex node : triangle)
      height += (node < planned.nodes_before ? rock.geometry.mesh.position[node]
                                             : planned.plan.nodes[node - planned.nodes_before].position)[1];
    const bool has_plus = std::find(triangle.begin(), triangle.end(), unit.plus) != triangle.end();
    const bool has_minus = std::find(triangle.begin(), triangle.end(), unit.minus) != triangle.end();
    const double towards_plus = std::copysign(1.0, unit.face[1]);
    if (has_plus) CHECK(height * towards_plus > 0);
    if (has_minus) CHECK(height * towards_plus < 0);
  }
}

TEST_CASE("every new node inside the rock is a mean of the corners of the element it lies in",
          "[structure][fracture]") {
  const GrowingRock rock(free_slit());
  const FractureTip tip = rock.tip_near({2.5, 0});
  const Planned planned = plan_from_tip(rock, tip, {{{2.7, 0.15}, std::nullopt}});
  const PatchPlan& plan = planned.plan;
  CHECK(planned.made(PlannedNode::Origin::interpolated) >= 1);
  for (const PlannedNode& node : plan.nodes) {
    if (node.origin == PlannedNode::Origin::copy) continue;
    double x = 0, y = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(node.weight[k] > -1e-9);
      x += node.weight[k] * rock.geometry.mesh.position[node.corner[k]][0];
      y += node.weight[k] * rock.geometry.mesh.position[node.corner[k]][1];
    }
    CHECK(x == Approx(node.position[0]).margin(1e-12));
    CHECK(y == Approx(node.position[1]).margin(1e-12));
  }
  for (const NodeIndex node : plan.unused)
    for (const auto& triangle : plan.made)
      CHECK(std::find(triangle.begin(), triangle.end(), node) == triangle.end());
}

TEST_CASE("a line that ends on the middle of another parts that one side of it in two",
          "[structure][fracture]") {
  const GrowingRock rock(slit_before_natural_fracture());
  const Mesh& mesh = rock.geometry.mesh;
  const FractureTip tip = rock.tip_near({-1, 0});
  VertexIndex wall = 0;
  for (VertexIndex v = 0; v < mesh.vertices.size(); ++v)
    if (mesh.vertices[v].position[0] == 0 && std::abs(mesh.vertices[v].position[1]) < 0.01) wall = v;
  REQUIRE(mesh.vertices[wall].units.size() == 1);
  const UnitIndex old = mesh.vertices[wall].units[0];
  const Planned planned = plan_from_tip(
      rock, tip, {{{-0.75, 0}, {}}, {{-0.5, 0}, {}}, {{-0.25, 0}, {}}, {mesh.vertices[wall].position, wall}});

  // Old tip, three new ones, junction: the last of the line has nothing ahead of it but the other fracture.
  CHECK(planned.plan.new_vertices.size() == 3);
  CHECK(planned.plan.split.size() == 5);
  const auto units = planned.units_of(wall);
  REQUIRE(units.size() == 3);
  const auto same = std::count_if(units.begin(), units.end(),
                                  [](const PlannedUnit& unit) { return unit.same.has_value(); });
  const auto parts =
      std::count_if(units.begin(), units.end(), [&](const PlannedUnit& unit) { return unit.source == old; });
  CHECK(same == 1);   // keeps the index of the old one
  CHECK(parts == 2);  // and both have its history
  // The two parts share the old faces, in their direction; the third is that of the arriving line.
  std::array<double, 2> face{};
  double old_length = 0, arriving = 0;
  for (const PlannedUnit& unit : units) {
    if (unit.source) {
      for (int axis = 0; axis < 2; ++axis) face[axis] += unit.face[axis];
      old_length += unit.length;
    } else {
      arriving += unit.length;
    }
  }
  CHECK(face[0] == Approx(mesh.units[old].face[0]).epsilon(1e-12));
  CHECK(std::abs(face[1] - mesh.units[old].face[1]) < 1e-12);
  CHECK(old_length == Approx(mesh.units[old].length).epsilon(1e-12));
  CHECK(arriving == Approx(0.125).epsilon(1e-9));
}

TEST_CASE("a line from one fracture's tip to another's splits both", "[structure][fracture]") {
  Case given = free_case(16);
  add_line(given, "west", FractureKind::open, {-5, 0}, {-0.5, 0});
  add_line(given, "east", FractureKind::open, {0, 0.1}, {5, 0.1});
  const GrowingRock rock(given);
  const FractureTip from = rock.tip_near({-0.5, 0}), to = rock.tip_near({0, 0.1});
  const Planned planned = plan_from_tip(rock, from, {{to.position, to.vertex}});
  CHECK(planned.plan.new_vertices.empty());
  CHECK(planned.plan.split == std::vector<VertexIndex>{from.vertex, to.vertex});
  CHECK(planned.made(PlannedNode::Origin::copy) == 2);
  CHECK(sum_of_lengths(planned.plan.units) > std::hypot(0.5, 0.1));
}

TEST_CASE("a line inside the rock splits none of its ends", "[structure][fracture]") {
  const GrowingRock rock(free_slit());
  const Mesh& mesh = rock.geometry.mesh;
  const auto start = static_cast<NodeIndex>(
      std::find_if(mesh.position.begin(), mesh.position.end(),
                   [](const Point& at) { return std::hypot(at[0] - 1, at[1] - 1) < 0.3; }) -
      mesh.position.begin());
  REQUIRE(start < mesh.position.size());
  const Point from = mesh.position[start];
  const Planned planned = plan_line(
      rock, start, {{from, {}}, {{from[0] + 0.25, from[1]}, {}}, {{from[0] + 0.5, from[1] + 0.05}, {}}});
  CHECK(planned.plan.new_vertices.size() == 3);
  CHECK(planned.plan.new_edges.size() == 2);
  REQUIRE(planned.plan.units.size() == 1);
  CHECK(planned.plan.units[0].vertex == mesh.vertices.size() + 1);
  CHECK(planned.plan.units[0].minus != planned.plan.units[0].plus);
}
