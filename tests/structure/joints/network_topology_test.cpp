// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "common/errors.hpp"
#include "structure/joints/joint_observation.hpp"
#include "structure/joints/network_topology.hpp"

using namespace fissura;
using namespace fissura::structure;

namespace {

/// A slit of three split vertices between two intact wings of two split vertices each; ends unsplit.
struct Fracture {
  Mesh mesh;
  Case run_case;
  Joints joints;

  Fracture() {
    FractureLine slit, wing;
    wing.kind = FractureKind::intact;
    wing.tensile_strength = 1e6;
    wing.fracture_energy = 50;
    run_case.rock.youngs_modulus = 32e9;
    run_case.fractures = {slit, wing};
    mesh.lines = run_case.fractures;
    run_case.injection.perforations = {{"perforation", {4.1, 0}, 2e-5}};
    for (VertexIndex v = 0; v < 9; ++v) {
      FractureVertex vertex;
      vertex.position = {static_cast<double>(v), 0};
      const bool in_slit = v > 2 && v < 6;
      if (v > 0 && v < 8) {
        ContactUnit unit;
        unit.face = {0, 1};
        unit.length = 1;
        unit.vertex = v;
        unit.line = in_slit ? 0u : 1u;
        vertex.units = {static_cast<UnitIndex>(mesh.units.size())};
        mesh.units.push_back(unit);
      }
      mesh.vertices.push_back(vertex);
      if (v > 0) add_edge(mesh, {v - 1, v, v > 2 && v < 7 ? 0u : 1u, 1});
    }
    joints = make_joints(mesh, run_case);
  }
};

}  // namespace

TEST_CASE("the first network holds the inside of the open fractures and the perforation", "[structure][joints]") {
  Fracture fracture;
  const Insertion first = first_insertion(fracture.mesh, fracture.joints, fracture.run_case);
  REQUIRE(first.new_nodes.size() == 3);
  CHECK(first.new_nodes[0].role == NodeRole::tip);
  CHECK(first.new_nodes[1].role == NodeRole::perforation);
  CHECK(first.new_nodes[1].lumped_length == 1);
  CHECK(first.new_segments.size() == 2);
  CHECK(first.new_perforations == std::vector<PerforationNode>{{"perforation", 4}});
}

TEST_CASE("growth at both tips connects each new vertex to its neighbour", "[structure][joints]") {
  Fracture fracture;
  FractureNetwork network;
  network.apply(first_insertion(fracture.mesh, fracture.joints, fracture.run_case));
  const Insertion growth = connect(fracture.mesh, network, {2, 6}, fracture.run_case, 1.5);
  CHECK(growth.revision == 1);
  REQUIRE(growth.new_nodes.size() == 2);
  CHECK(growth.new_nodes[0].exposure_time == 1.5);
  CHECK(growth.new_nodes[0].role == NodeRole::tip);
  CHECK(growth.new_segments.size() == 2);
  CHECK(growth.parents == std::vector<NodeParent>{{2, 3}, {6, 5}});
  REQUIRE(growth.updated_nodes.size() == 2);
  CHECK(growth.updated_nodes[0].role == NodeRole::interior);
  network.apply(growth);
  CHECK(network.nodes().size() == 5);
}

TEST_CASE("a perforation outside the open fractures is a fault of the case", "[structure][joints]") {
  Fracture fracture;
  fracture.run_case.injection.perforations[0].position = {7, 0};
  CHECK_THROWS_WITH(first_insertion(fracture.mesh, fracture.joints, fracture.run_case),
                    Catch::Contains("perforation at (7, 0) m does not lie inside an open fracture"));
}

TEST_CASE("the network is told gap plus stored aperture, and the pressure that would open a closed node",
          "[structure][joints]") {
  Fracture fracture;
  FractureNetwork network;
  network.apply(first_insertion(fracture.mesh, fracture.joints, fracture.run_case));
  network.apply(connect(fracture.mesh, network, {6}, fracture.run_case, 0));
  fracture.joints.state[3].opening = 1e-4;
  fracture.joints.state[3].closed = false;
  fracture.joints.state[5].held_normal = -5e6;
  const JointObservation seen = observe_joints(fracture.mesh, fracture.joints, network);
  CHECK(seen.aperture[1] == Approx(1.2e-4).epsilon(1e-12));
  CHECK(seen.closed[1] == 0);
  CHECK(seen.closed[0] == 1);
  CHECK(seen.pressure_opening[3] == Approx(6e6).epsilon(1e-12));
  CHECK(seen.broken[1] == 1);
  CHECK(seen.broken[3] == 0);
}
