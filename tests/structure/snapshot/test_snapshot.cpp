// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <random>

#include "common/errors.hpp"
#include "common/fracture_network/insertion_archive.hpp"
#include "structure/dynamics/energy.hpp"
#include "structure/joints/network_topology.hpp"
#include "structure/structure_run.hpp"
#include "structure/structure_snapshot.hpp"
#include "tests/fakes/structure/mesh_changes.hpp"
#include "tests/fakes/structure/shale_case.hpp"
#include "tests/structure/fracture/growing_rock.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

Case slit_case() {
  Case settings = stressed_shale_case();
  settings.domain = {40, 40, 1};
  settings.mesh = {0.5, 2, 2, 0.3, 1, 0.5, 2, 0.4, {}, {}};
  settings.boundary.west.kind = BoundaryKind::roller;
  settings.fractures.push_back(
      {.name = "slit", .points = {{-4, 0}, {4, 0}}, .friction_coefficient = 0.5, .set = {}});
  settings.fractures.push_back({.name = "joint",
                                .kind = FractureKind::natural,
                                .points = {{8, -4}, {8, 4}},
                                .friction_coefficient = 0.02,
                                .cohesion = 1e5,
                                .dilation_angle = 0.1,
                                .set = {}});
  settings.fractures.back().dilation_slip = 1;
  return settings;
}

struct Structure {
  StructureModel model{slit_case(), elasticity(slit_case().rock), 1};
  Geometry geometry = build_geometry(model);
  StructureState state = initial_state(model, geometry);
  StructureHistory history;

  Structure() {
    history.insertions.push_back(first_insertion(geometry.mesh, state.joints, model.run_case));
    geometry.network = network_after(history.insertions);
  }

  [[nodiscard]] std::vector<std::byte> save() const {
    return save_snapshot(structure_owner(model.run_case), history, geometry, state, {});
  }
  void restore(const std::vector<std::byte>& bytes) {
    Snapshot snapshot = restore_snapshot(bytes, structure_owner(model.run_case), model);
    geometry = std::move(snapshot.geometry);
    state = std::move(snapshot.state);
    history = std::move(snapshot.history);
  }

  void advance(double begin, double end) {
    for (PressureRamp& ramp : state.joints.ramp) ramp = {20e6, 20e6, 0, 0, 0};
    StructureRun(model, geometry).advance(begin, end, state);
  }

  void follow(const MeshChange& change) {
    structure::follow(model, change, geometry);
    state.body.displacement.resize(2 * geometry.mesh.position.size(), 0);
    state.body.velocity.resize(2 * geometry.mesh.position.size(), 0);
    for (const UnitIndex unit : change.new_units) {
      state.joints.properties.push_back(joint_properties(geometry.mesh, unit, model.run_case.rock));
      state.joints.state.push_back({});
      state.joints.released.push_back(1);
      state.joints.ramp.push_back({});
    }
  }

  void change_mesh() {
    Mesh& mesh = geometry.mesh;
    follow(refine(mesh, {5, 1}, 1));
    follow(coarsen(mesh, {-10, 10}, 6));
    mesh.lines.push_back({.name = "grown",
                          .kind = FractureKind::intact,
                          .points = {{-10, -10}, {-9, -10}},
                          .tensile_strength = 1e6,
                          .fracture_energy = 100,
                          .friction_coefficient = 0.6,
                          .set = {}});
    follow(tear(mesh, {-10, -10}));
    follow(refine(mesh, {-10, -8}, 2));
  }
};

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

void require_same_motion(const Structure& a, const Structure& b) {
  REQUIRE(same_bits(a.state.body.displacement, b.state.body.displacement));
  REQUIRE(same_bits(a.state.body.velocity, b.state.body.velocity));
  for (std::size_t u = 0; u < a.state.joints.state.size(); ++u)
    for (const auto member : {&JointState::opening, &JointState::sliding, &JointState::slip,
                              &JointState::dilation, &JointState::sliding_at_rest})
      REQUIRE(a.state.joints.state[u].*member == b.state.joints.state[u].*member);
}

}  // namespace

TEST_CASE("a structure restored after insertions goes on bit for bit, through further insertions",
          "[structure][snapshot]") {
  Structure original;
  original.advance(0, 0.01);
  original.change_mesh();
  original.advance(0.01, 0.02);
  Structure copy;
  copy.restore(original.save());
  CHECK(copy.geometry.number == original.geometry.number);
  CHECK(copy.geometry.mesh.lines.back().name == "grown");
  CHECK(kinetic_energy(original.geometry.body, original.state.body.velocity, 1) > 0);
  require_same_motion(original, copy);
  const auto dilated = [](const JointState& state) { return state.dilation > 0; };
  CHECK(std::any_of(copy.state.joints.state.begin(), copy.state.joints.state.end(), dilated));
  for (Structure* structure : {&original, &copy}) {
    structure->advance(0.02, 0.03);
    structure->follow(refine(structure->geometry.mesh, {-5, -1}, 1));
    structure->follow(coarsen(structure->geometry.mesh, {10, -10}, 6));
    structure->advance(0.03, 0.04);
  }
  require_same_motion(original, copy);
  CHECK(original.geometry.frequency_squared == copy.geometry.frequency_squared);
  CHECK(original.geometry.mesh.unused_nodes == copy.geometry.mesh.unused_nodes);
}

TEST_CASE("fractures that grew before and after a restart do so bit for bit", "[structure][snapshot]") {
  GrowingRock original(free_slit());
  original.grow_along(0.2, 3);
  GrowingRock copy(free_slit());
  const StateOwner owner = structure_owner(copy.model.run_case);
  StructureHistory history;
  history.insertions.push_back(first_insertion(copy.geometry.mesh, copy.state.joints, copy.model.run_case));
  Snapshot snapshot = restore_snapshot(save_snapshot(owner, history, original.geometry, original.state, {}),
                                       owner, copy.model);
  copy.geometry = std::move(snapshot.geometry);
  copy.state = std::move(snapshot.state);
  copy.geometry.network = original.geometry.network;
  for (GrowingRock* rock : {&original, &copy}) {
    REQUIRE(rock->grow_along(-0.3, 3) == 6);
    StructureRun(rock->model, rock->geometry).advance(0, 0.01, rock->state);
  }
  CHECK(same_bits(original.state.body.displacement, copy.state.body.displacement));
  CHECK(same_bits(original.state.body.velocity, copy.state.body.velocity));
  CHECK(original.geometry.mesh.elements == copy.geometry.mesh.elements);
  CHECK(original.geometry.frequency_squared == copy.geometry.frequency_squared);
}

TEST_CASE("a structure goes back behind its insertions to the mesh of the case", "[structure][snapshot]") {
  Structure original;
  original.advance(0, 0.01);
  original.history.time = 0.01;
  original.history.steps = 3;
  const auto bytes = original.save();
  Structure other;
  other.change_mesh();
  other.restore(bytes);
  CHECK(other.history.time == 0.01);
  CHECK(other.history.steps == 3);
  CHECK(other.geometry.number == 0);
  original.advance(0.01, 0.02);
  other.advance(0.01, 0.02);
  require_same_motion(original, other);
}

TEST_CASE("a snapshot that is cut short, changed, or of another case is refused", "[structure][snapshot]") {
  Structure original;
  original.change_mesh();
  const auto bytes = original.save();
  Structure other;
  const auto refused = [&](const std::vector<std::byte>& wrong, const char* why) {
    CHECK_THROWS_WITH(other.restore(wrong), Catch::Contains(why));
    try {
      other.restore(wrong);
    } catch (const Error& error) {
      CHECK(error.code() == ExitCode::checkpoint_unusable);
    }
  };
  for (const std::size_t length : {std::size_t{0}, std::size_t{9}, bytes.size() / 4, bytes.size() - 1})
    refused({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)}, "saved state");
  for (std::size_t at = 8; at < bytes.size(); at += bytes.size() / 50) {
    auto flipped = bytes;
    flipped[at] ^= std::byte{4};
    refused(flipped, "checksum");
  }
  other.model.run_case.rock.density += 1;
  refused(bytes, "another case");
  CHECK(other.geometry.number == 0);
}

TEST_CASE("a snapshot that was changed under a right checksum is refused, or is a structure that can go on",
          "[structure][snapshot]") {
  Structure original;
  original.advance(0, 0.01);
  original.change_mesh();
  const StateOwner owner = structure_owner(original.model.run_case);
  const std::vector<std::byte> blob = original.save();
  const auto inside = state_inside(blob, owner);
  std::mt19937_64 random(5);
  int refused = 0, taken = 0;
  Structure other;
  for (int round = 0; round < 200; ++round) {
    std::vector<std::byte> changed(inside.begin(), inside.end());
    const std::size_t at = random() % (changed.size() - 8);
    if (round % 2 == 0)
      changed[at] = static_cast<std::byte>(random());
    else
      for (std::size_t k = 0; k < 8; ++k) changed[at + k] = static_cast<std::byte>(random());
    ByteWriter bytes;
    begin_state(owner, bytes);
    for (const std::byte value : changed) bytes.put(value);
    const std::vector<std::byte> forged = end_state(bytes);
    try {
      other.restore(forged);
      ++taken;
      REQUIRE(other.save() == forged);
      const double step = stable_step(other.model, other.geometry, other.state);
      StructureRun(other.model, other.geometry).advance(0, step, other.state);
    } catch (const Error&) {
      ++refused;
    }
  }
  CHECK(refused > 0);
  CHECK(taken > 0);
}
