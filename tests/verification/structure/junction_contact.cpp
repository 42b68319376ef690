// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "structure/structure_run.hpp"
#include "tests/structure/fracture/growing_rock.hpp"

/// Closed fractures that cross and meet, under compression and with friction enough, move like rock without
/// fractures: the waves of a sudden load pass through them.

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

/// A cross and a T of natural fractures, in compression; the sides are pressed unequally at time 0.
Case crossed_rock() {
  Case given = free_case(12);
  given.mesh.far_size = 0.5;
  given.in_situ.stress = {-10e6, -12e6, 1e6, -10e6};
  given.dynamics.damping = 0;
  given.boundary.west.value = {2e6, 0};
  given.boundary.east.value = {-1e6, 0};
  given.boundary.north.value = {0, -3e6};
  add_line(given, "level", FractureKind::natural, {-3, 0}, {3, 0});
  add_line(given, "steep", FractureKind::natural, {-1, -2}, {1, 2});
  add_line(given, "arriving", FractureKind::natural, {2, 2.5}, {2, 0});
  for (FractureLine& line : given.fractures) line.friction_coefficient = 5;
  return given;
}

/// The same mesh with one node at every place.
Mesh welded(Mesh mesh) {
  std::map<Point, NodeIndex> first;
  std::vector<NodeIndex> node(mesh.position.size());
  for (NodeIndex k = 0; k < node.size(); ++k) node[k] = first.emplace(mesh.position[k], k).first->second;
  for (auto& element : mesh.elements)
    for (NodeIndex& corner : element) corner = node[corner];
  for (NodeIndex k = 0; k < node.size(); ++k)
    if (node[k] != k) mesh.unused_nodes.push_back(k);
  mesh.units.clear();
  mesh.edges.clear();
  mesh.vertices.clear();
  return mesh;
}

Geometry built_on(const Mesh& mesh, const StructureModel& model) {
  Geometry geometry;
  geometry.mesh = mesh;
  geometry.node_elements = NodeElements(mesh);
  geometry.body = build_body(mesh, model.run_case);
  geometry.joint_nodes = joint_nodes(mesh);
  geometry.tiles = build_tiles(mesh, geometry.body, geometry.joint_nodes);
  geometry.frequency_bound = bound_frequencies(mesh, model.moduli, model.run_case.rock.density);
  geometry.frequency_squared = stiffest_element(mesh, geometry.frequency_bound).frequency_squared;
  return geometry;
}

}  // namespace

TEST_CASE("closed junctions in compression pass waves on like intact rock", "[verification][structure]") {
  GrowingRock split(crossed_rock());
  const Geometry whole = built_on(welded(split.geometry.mesh), split.model);
  StructureState state = initial_state(split.model, whole);
  const Mesh& mesh = split.geometry.mesh;
  const auto junctions = std::count_if(mesh.vertices.begin(), mesh.vertices.end(),
                                       [](const FractureVertex& vertex) { return vertex.units.size() > 2; });
  REQUIRE(junctions == 2);

  StructureRun split_run(split.model, split.geometry), whole_run(split.model, whole);
  const double step = 0.9 * std::min(stable_step(split.model, split.geometry, split.state),
                                     stable_step(split.model, whole, state));
  double time = 0;
  for (int k = 0; k < 400; ++k, time += step) {
    REQUIRE(split_run.advance(time, time + step, split.state) == 1);
    REQUIRE(whole_run.advance(time, time + step, state) == 1);
  }
  double difference = 0, scale = 0;
  std::map<Point, NodeIndex> at;
  for (const auto& element : whole.mesh.elements)
    for (const NodeIndex node : element) at.emplace(mesh.position[node], node);
  for (NodeIndex node = 0; node < mesh.position.size(); ++node)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double expected = state.body.displacement[2 * at.at(mesh.position[node]) + axis];
      difference = std::max(difference, std::abs(split.state.body.displacement[2 * node + axis] - expected));
      scale = std::max(scale, std::abs(expected));
    }
  CAPTURE(difference, scale);
  CHECK(scale > 1e-4);
  CHECK(difference < 1e-5 * scale);  // the impulses at junctions settle to 1e-6
  for (const JointState& joint : split.state.joints.state) CHECK(joint.closed);
}
