// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "tests/fakes/structure/shale_case.hpp"
#include "structure/joints/network_topology.hpp"
#include "structure/joints/wet_release.hpp"

using namespace fissura;
using namespace fissura::structure;

namespace {

/// Five vertices on a line, three of them split; the first two are in the network, the third is held ahead of the tip.
struct Wing {
  Mesh mesh;
  Case run_case = fakes::shale_case();
  Joints joints;
  FractureNetwork network;

  Wing() {
    FractureLine slit, path;
    slit.kind = FractureKind::open;
    path.kind = FractureKind::intact;
    path.tensile_strength = 1e6;
    path.fracture_energy = 50;
    run_case.fractures = {slit, path};
    mesh.lines = run_case.fractures;
    run_case.injection.perforations = {{"perforation", {1, 0}, 1e-5}};
    for (VertexIndex v = 0; v < 5; ++v) {
      FractureVertex vertex;
      vertex.position = {static_cast<double>(v), 0};
      if (v > 0 && v < 4) {
        ContactUnit unit;
        unit.face = {0, 1};
        unit.length = 1;
        unit.vertex = v;
        unit.line = v < 3 ? 0u : 1u;
        vertex.units = {static_cast<UnitIndex>(mesh.units.size())};
        mesh.units.push_back(unit);
      }
      mesh.vertices.push_back(vertex);
      if (v > 0) add_edge(mesh, {v - 1, v, v < 3 ? 0u : 1u, 1});
    }
    joints = make_joints(mesh, run_case);
    network.apply(first_insertion(mesh, joints, run_case));
  }
};

}  // namespace

TEST_CASE("a tip grows when traction and fluid pressure together reach the strength", "[structure][joints]") {
  Wing wing;
  wing.joints.state[1].pressure = 6e6;
  wing.joints.state[2].held_normal = -5.01e6;
  CHECK(vertices_to_release(wing.mesh, wing.joints, wing.network).empty());
  wing.joints.state[2].held_normal = -4.99e6;
  CHECK(vertices_to_release(wing.mesh, wing.joints, wing.network) == std::vector<VertexIndex>{3});
}

TEST_CASE("a dry tip under compression does not grow", "[structure][joints]") {
  Wing wing;
  wing.joints.state[2].held_normal = -4.99e6;
  CHECK(vertices_to_release(wing.mesh, wing.joints, wing.network).empty());
}

TEST_CASE("a released vertex is closed, dry and as strong as before", "[structure][joints]") {
  Wing wing;
  release(wing.mesh, 3, wing.joints);
  CHECK(wing.joints.released[2] == 1);
  CHECK(wing.joints.state[2].closed);
  CHECK(wing.joints.state[2].pressure == 0);
  CHECK(wing.joints.state[2].greatest_separation == 0);
  CHECK_FALSE(wing.joints.broken(2));
}

TEST_CASE("strength is lowered, never the energy, where the mesh cannot resolve the cohesive zone", "[common][case]") {
  constexpr double modulus = 33.3333e9;
  CHECK(tip_strength(1e6, 50, modulus, 0.5) == 1e6);
  // sqrt(E' G_f / (1.5 h)) for 4 MPa at h = 0.5 m.
  CHECK(tip_strength(4e6, 50, modulus, 0.5) == Approx(1.4907e6).epsilon(1e-4));
}
