// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "common/errors.hpp"
#include "structure/joints/face_pair.hpp"
#include "structure/joints/joint_observation.hpp"
#include "structure/joints/natural_figures.hpp"
#include "structure/joints/sliding_limit.hpp"
#include "tests/structure/joints/block_pair.hpp"

using namespace fissura;
using namespace fissura::structure;
using fakes::BlockPair;

namespace {

constexpr double mass = 100, length = 0.5, step = 1e-4, slope = 0.2, greatest_slip = 1e-3, pressed = 10e6;
const JointStepControls undamped{step, 1, 0, 1};

JointProperties rough() {
  JointProperties properties;
  properties.kind = FractureKind::natural;
  properties.friction_coefficient = 0.6;
  properties.dilation = slope;
  properties.dilation_slip = greatest_slip;
  return properties;
}

void shear(BlockPair& pair, double traction) {
  pair.step({traction * length, pressed * length}, {-traction * length, -pressed * length}, undamped);
}

/// Three vertices in a row on a natural fracture beside an open slit.
struct Row {
  Mesh mesh;
  Joints joints;
  FractureNetwork network;

  Row() {
    FractureLine natural, slit;
    natural.name = "fault";
    natural.kind = FractureKind::natural;
    natural.residual_aperture = 5e-5;
    slit.kind = FractureKind::open;
    mesh.lines = {natural, slit};
    for (VertexIndex v = 0; v < 5; ++v) {
      FractureVertex vertex;
      vertex.position = {2.0 * v, 0};
      vertex.units = {v};
      ContactUnit unit;
      unit.face = {0, 2};
      unit.length = 2;
      unit.vertex = v;
      unit.line = v < 3 ? 0u : 1u;
      mesh.units.push_back(unit);
      mesh.vertices.push_back(vertex);
      joints.properties.push_back(joint_properties(mesh, v, Rock{}));
    }
    for (VertexIndex v = 0; v < 4; ++v)
      add_edge(mesh, {v, v + 1, v < 2 ? 0u : 1u, v == 0 ? 1.0 : 2.0, {v, v + 1}});
    joints.state.resize(5);
    joints.released.assign(5, 1);
    joints.ramp.resize(5);
    Insertion first;
    for (NodeId id = 2; id < 5; ++id) {
      NetworkNode node;
      node.id = id;
      node.lumped_length = 2;
      first.new_nodes.push_back(node);
    }
    first.new_segments = {{2, 2, 3, 1, SegmentKind::hydraulic, 2}, {3, 3, 4, 1, SegmentKind::hydraulic, 2}};
    network.apply(first);
  }
};

}  // namespace

TEST_CASE("touching faces that slide ride up: opening = slip tan psi, up to the limit",
          "[structure][joints]") {
  BlockPair pair(rough(), mass, length);
  double fastest = 0, slid = 0;
  while (pair.state().slip < 2 * greatest_slip) {
    shear(pair, 7e6);
    const double sliding = std::abs(pair.velocity_plus()[0] - pair.velocity_minus()[0]);
    const double parting = pair.velocity_plus()[1] - pair.velocity_minus()[1];
    CHECK(parting <= 1.1 * slope * sliding * (1 + 1e-9));
    REQUIRE(pair.state().closed);
    fastest = std::max(fastest, parting);
    const double due = slope * std::min(pair.state().slip, greatest_slip), one_step = slope * sliding * step;
    CHECK(pair.state().opening <= due + 1e-15);
    CHECK(pair.state().opening >= due - one_step - 1e-15);
    slid = pair.state().slip;
  }
  REQUIRE(slid > greatest_slip);
  CHECK(fastest > 0);
  CHECK(pair.state().opening == Approx(slope * greatest_slip).epsilon(1e-9));
  CHECK(aperture(rough(), pair.state()) == pair.state().opening);
}

TEST_CASE("faces that have dilated part and meet again where they touched", "[structure][joints]") {
  BlockPair pair(rough(), mass, length);
  while (pair.state().slip < 2 * greatest_slip) shear(pair, 7e6);
  const double touch = pair.state().opening;
  pair.set_velocity_plus({pair.velocity_minus()[0], pair.velocity_minus()[1] + 0.5});
  pair.set_ramp({2 * pressed, 2 * pressed, 0, 0, 0});
  shear(pair, 0);
  CHECK_FALSE(pair.state().closed);
  CHECK(pair.state().opening > touch);
  pair.set_ramp({});
  for (int k = 0; k < 200; ++k) {
    shear(pair, 0);
    CHECK(pair.state().opening > touch - 1e-12);
  }
  CHECK(pair.state().closed);
  CHECK(pair.state().opening == Approx(touch).margin(contact_tolerance));
}

TEST_CASE("a fall of the step does not make dilation burst", "[structure][joints]") {
  BlockPair pair(rough(), mass, length);
  for (int k = 0; k < 20; ++k) shear(pair, 7e6);
  const double sliding = std::abs(pair.velocity_plus()[0] - pair.velocity_minus()[0]);
  JointStepControls fine = undamped;
  fine.step = step / 1000;
  for (int k = 0; k < 100; ++k) {
    pair.step({7e6 * length, pressed * length}, {-7e6 * length, -pressed * length}, fine);
    CHECK(pair.velocity_plus()[1] - pair.velocity_minus()[1] <= 1.1 * slope * sliding * (1 + 1e-3));
  }
}

TEST_CASE("cement keeps the residual aperture out until it breaks", "[structure][joints]") {
  JointProperties cemented = rough();
  cemented.residual_aperture = 5e-5;
  JointState state;
  CHECK(aperture(cemented, state) == 5e-5);
  cemented.cohesive = {1e6, 50};
  CHECK(aperture(cemented, state) == 0);
  state.greatest_separation = cemented.cohesive.critical_opening() / 2;
  CHECK(aperture(cemented, state) == Approx(2.5e-5).epsilon(1e-12));
  state.greatest_separation = 1;
  CHECK(aperture(cemented, state) == 5e-5);
  CHECK(greatest_shear_traction(cemented, state, pressed) == Approx(0.6 * pressed));
}

TEST_CASE("every arm has its own aperture, every node their mean", "[structure][joints]") {
  Row row;
  row.joints.state[3].opening = 1e-3;
  row.joints.state[3].closed = false;
  const JointObservation seen = observe_joints(row.mesh, row.joints, row.network);
  CHECK(seen.aperture == std::vector<double>{5e-5, 1e-3, 0});
  CHECK(seen.arm_aperture_a == std::vector<double>{5e-5, 1e-3});
  CHECK(seen.arm_aperture_b == std::vector<double>{1e-3, 0});
}

TEST_CASE("what is told of natural fractures is their slip, opening, water and distance",
          "[structure][joints]") {
  Row row;
  row.joints.state[0].sliding = -2e-4;
  row.joints.state[1].sliding = 3e-4;
  row.joints.state[3].sliding = 1;
  row.joints.state[2].opening = 1e-4;
  row.joints.state[2].closed = false;
  const NaturalFigures figures = natural_figures(row.mesh, row.joints, row.network, 3);
  CHECK(figures.greatest_slip == 3e-4);
  CHECK(figures.slipped_length == 4);
  CHECK(figures.opened_length == 2);
  CHECK(figures.wetted_length == 2);
  CHECK(figures.slip_distance == Approx(4));
  CHECK(figures.greatest_far_slip == 2e-4);
}

TEST_CASE("sliding by more than half the shorter adjoining edge is refused", "[structure][joints][fault]") {
  Row row;
  const std::vector<double> limits = sliding_limits(row.mesh);
  CHECK(limits == std::vector<double>{0.5, 0.5, 1, 1, 1});
  row.joints.state[1].sliding = -0.3;
  row.joints.state[1].sliding_at_rest = -0.19;
  CHECK_NOTHROW(require_facing_pairs(row.mesh, row.joints, limits));
  row.joints.state[1].sliding = -0.32;
  CHECK_THROWS_WITH(
      require_facing_pairs(row.mesh, row.joints, limits),
      "fracture 'fault' has slid by 0.51 m at (2, 0) m, more than half of its shorter edge there, 0.5 m: its "
      "nodes no longer face each other; make mesh.natural_size larger than 1.02 m");
}
