// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "structure/dynamics/element_fields.hpp"
#include "structure/joints/network_topology.hpp"
#include "structure/structure_run.hpp"
#include "structure/structure_snapshot.hpp"
#include "tests/structure/fracture/failing_rock.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

constexpr double interval = 2e-3;  // [s]

// A slit, a natural fracture that crosses it and one aside, in rock that cracks and flows.
Case shaken_case() {
  Case given = failing_slit();
  given.domain.thickness = 10;
  given.growth.tip = Case{}.growth.tip;
  given.growth.nucleation = false;
  given.growth.path = PathRule::prescribed;
  add_line(given, "crossing", FractureKind::natural, {1, -2}, {1, 2});
  add_line(given, "aside", FractureKind::natural, {-5, 3}, {-2, 5});
  for (FractureLine& line : given.fractures) line.friction_coefficient = 0.2;
  given.fractures.back().tensile_strength = 1e5;
  given.fractures.back().fracture_energy = 5;
  given.in_situ.stress = {-2e6, -1e6, 0.4e6, -2e6};
  given.bulk_failure.cohesion = 3e6;
  given.bulk_failure.friction_angle = 0.5;
  given.bulk_failure.tip_exclusion = 0;
  given.dynamics.damping = 0;
  return given;
}

struct ShakenRock : GrowingRock {
  explicit ShakenRock(int threads) : GrowingRock(shaken_case()) {
    model.threads = threads;
    for (std::size_t node = 0; node < geometry.mesh.position.size(); ++node) {
      const auto [x, y] = geometry.mesh.position[node];
      state.body.velocity[2 * node] = 0.5 * std::sin(0.9 * x) * std::cos(0.7 * y);
      state.body.velocity[2 * node + 1] = 0.5 * std::cos(0.5 * x) * std::sin(1.1 * y);
    }
  }

  void advance(int index) {
    const double pressure = 3e6 * (1 + std::sin(index));
    for (PressureRamp& ramp : state.joints.ramp) ramp = {pressure, pressure, 0, 0, 0};
    StructureRun(model, geometry).advance((index - 1) * interval, index * interval, state);
  }

  std::vector<SourceRecord> sources(int index) {
    advance(index);
    return state.sources.take(static_cast<std::uint64_t>(index));
  }

  void tell_quiet() { state.sources.tell_quiet(observed_rock(model, geometry, state), state.joints); }
};

// Of all jumps and of what failed elements lack of the stress of whole ones, from the displacements anew.
PlaneTensor present_moment(const GrowingRock& rock) {
  const Mesh& mesh = rock.geometry.mesh;
  const std::vector<double>& u = rock.state.body.displacement;
  const auto records = damage_records(rock.geometry.tiles, rock.state.body.damage);
  const auto& body = rock.geometry.body;
  const auto whole = effective_stress(mesh, body, rock.model.moduli, u, {});
  const auto failed = effective_stress(mesh, body, rock.model.moduli, u, records);
  const double thickness = rock.model.run_case.domain.thickness;
  PlaneTensor moment{};
  for (ElementIndex e = 0; e < mesh.elements.size(); ++e)
    moment = moment + thickness * element_area(mesh, e) * (tensor_of(whole[e]) - tensor_of(failed[e]));
  for (const ContactUnit& unit : mesh.units) {
    const double length = std::hypot(unit.face[0], unit.face[1]);
    const std::array<double, 2> jump{u[2 * unit.plus] - u[2 * unit.minus],
                                     u[2 * unit.plus + 1] - u[2 * unit.minus + 1]};
    moment = moment + moment_of_jump(rock.model.moduli, {unit.face[0] / length, unit.face[1] / length}, jump,
                                     thickness * length);
  }
  return moment;
}

struct Sum {
  PlaneTensor moment{};
  double scale = 0;

  void add(const std::vector<SourceRecord>& records) {
    for (const SourceRecord& record : records) {
      moment = moment + record.moment;
      scale += size_of(record.moment);
    }
  }
};

bool has(const std::vector<SourceRecord>& records, SourceKind kind) {
  return std::any_of(records.begin(), records.end(),
                     [&](const SourceRecord& record) { return record.kind == kind; });
}

}  // namespace

TEST_CASE("all that was told is the present jump of the faces and the present glut of the rock",
          "[structure][seismicity]") {
  std::mt19937 random(GENERATE(1u, 2u, 3u));
  ShakenRock rock(1);
  Sum told;
  bool slid = false, cracked = false, opened = false, flowed = false;
  constexpr int intervals = 30;
  for (int index = 1; index <= intervals; ++index) {
    rock.advance(index);
    if (random() % 4 == 0 || index == intervals) rock.tell_quiet();
    const auto records = rock.state.sources.take(static_cast<std::uint64_t>(index));
    CHECK(std::is_sorted(records.begin(), records.end(), comes_before));
    for (const SourceRecord& record : records) {
      REQUIRE(record.begin <= record.centroid_time);
      REQUIRE(record.centroid_time <= record.end);
      REQUIRE(record.end > (index - 1) * interval);
      REQUIRE(record.end <= index * interval);
    }
    told.add(records);
    slid = slid || has(records, SourceKind::contact_slip);
    cracked = cracked || has(records, SourceKind::bulk_tension);
    opened = opened || has(records, SourceKind::new_crack);
    flowed = flowed || has(records, SourceKind::bulk_shear) || has(records, SourceKind::bulk_compaction);
  }
  CHECK(slid);
  CHECK(cracked);
  CHECK(opened);
  CHECK(flowed);
  const PlaneTensor present = present_moment(rock);
  CHECK(size_of(present) > 1e6);
  CHECK(size_of(told.moment - present) < 1e-12 * told.scale);
  CHECK(rock.state.sources.transferred() == PlaneTensor{});
}

TEST_CASE("the sources are the same bits for one and for two threads", "[structure][seismicity]") {
  ShakenRock one(1), two(2);
  std::size_t records = 0;
  for (int index = 1; index <= 10; ++index) {
    const auto of_one = one.sources(index);
    REQUIRE(of_one == two.sources(index));
    records += of_one.size();
  }
  CHECK(records > 100);
}

TEST_CASE("a structure that was saved in the middle of an episode tells the same afterwards",
          "[structure][seismicity]") {
  ShakenRock rock(1);
  for (int index = 1; index <= 6; ++index) rock.sources(index);
  const StateOwner owner = structure_owner(rock.model.run_case);
  StructureHistory history;
  history.insertions.push_back(first_insertion(rock.geometry.mesh, rock.state.joints, rock.model.run_case));
  const auto bytes = save_snapshot(owner, history, rock.geometry, rock.state, {});
  ShakenRock other(1);
  other.state = restore_snapshot(bytes, owner, other.model).state;
  for (int index = 7; index <= 12; ++index) {
    rock.advance(index);
    other.advance(index);
    if (index == 12) {
      rock.tell_quiet();
      other.tell_quiet();
    }
    const auto records = rock.state.sources.take(1);
    CHECK(records.size() > 10);
    REQUIRE(records == other.state.sources.take(1));
  }
}

TEST_CASE("a structure without seismicity keeps and tells nothing", "[structure][seismicity]") {
  Case quiet = shaken_case();
  quiet.seismicity.active = false;
  GrowingRock rock(quiet);
  rock.pull_across(0.3);
  StructureRun(rock.model, rock.geometry).advance(0, interval, rock.state);
  rock.state.sources.tell_quiet(observed_rock(rock.model, rock.geometry, rock.state), rock.state.joints);
  CHECK(rock.state.sources.take(1).empty());
  CHECK(rock.state.joints.movement.empty());
}

TEST_CASE("an insertion is no source: told + transferred goes on being the present moment",
          "[structure][seismicity]") {
  GrowingRock rock(failing_slit());
  const double h = rock.h();
  fail(rock, 0.8,
       [&](const Point& at) { return at[0] > 2.5 && at[0] < 2.5 + 3.5 * h && std::abs(at[1]) < 0.7 * h; });
  rock.pull_across(0);
  const double step = 0.5 * stable_step(rock.model, rock.geometry, rock.state);
  const auto advance = [&](int index) {
    StructureRun(rock.model, rock.geometry).advance((index - 1) * step, index * step, rock.state);
  };
  const PlaneTensor start = present_moment(rock);
  Sum told;
  advance(1);
  const GrowthPlan plan = rock.plan();
  rock.state.sources.tell_quiet(observed_rock(rock.model, rock.geometry, rock.state), rock.state.joints,
                                entities_that_change(plan));
  const auto before = rock.state.sources.take(1);
  told.add(before);
  const PlaneTensor before_insertion = present_moment(rock);
  rock.insert(plan);
  const PlaneTensor change = present_moment(rock) - before_insertion;
  CHECK(size_of(change) > 1e-3 * size_of(before_insertion));  // the rock was healed, the faces opened
  CHECK(rock.state.sources.take(1).empty());
  advance(2);
  rock.state.sources.tell_quiet(observed_rock(rock.model, rock.geometry, rock.state), rock.state.joints);
  told.add(rock.state.sources.take(2));
  const double scale = told.scale + size_of(change) + size_of(start);
  CHECK(size_of(rock.state.sources.transferred() - change) < 1e-12 * scale);
  const PlaneTensor expected = present_moment(rock) - start;
  CHECK(size_of(told.moment + rock.state.sources.transferred() - expected) < 1e-12 * scale);
  for (const SourceRecord& record : before) CHECK(record.geometry == 0);
}
