// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "structure/joints/joining_vertices.hpp"
#include "structure/joints/network_topology.hpp"
#include "tests/structure/fracture/growing_rock.hpp"
#include "tests/structure/fracture/mesh_faults.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

void require_sound(const GrowingRock& rock) {
  const auto faults = mesh_faults(rock.geometry.mesh, rock.model.run_case.domain);
  for (const std::string& fault : faults) UNSCOPED_INFO(fault);
  REQUIRE(faults.empty());
}

Case meeting_case(CrossingRule rule) {
  Case given = slit_before_natural_fracture();
  given.growth.crossing = rule;
  given.in_situ.pore_pressure = 3e6;
  return given;
}

/// Grows east until something is met. @returns the plan that did
GrowthPlan grow_until_met(GrowingRock& rock) {
  for (int k = 0; k < 12; ++k) {
    rock.pull_across(0);
    const GrowthPlan plan = rock.plan();
    rock.insert(plan);
    require_sound(rock);
    if (!plan.meetings.empty()) return plan;
  }
  throw std::logic_error("nothing was met");
}

std::size_t vertices_of(const Mesh& mesh, const std::string& line) {
  std::size_t count = 0;
  for (const FractureVertex& vertex : mesh.vertices)
    count += !vertex.units.empty() &&
             std::any_of(vertex.edges.begin(), vertex.edges.end(),
                         [&](EdgeIndex edge) { return mesh.lines[mesh.edges[edge].line].name == line; });
  return count;
}

std::size_t saturated(const GrowthPlan& plan) {
  return static_cast<std::size_t>(std::count_if(plan.insertion.new_nodes.begin(),
                                                plan.insertion.new_nodes.end(),
                                                [](const NetworkNode& node) { return node.saturated; }));
}

double easternmost(const Mesh& mesh) {
  double x = -1e9;
  for (const FractureVertex& vertex : mesh.vertices) x = std::max(x, vertex.position[0]);
  return x;
}

}  // namespace

TEST_CASE("a natural fracture that is met joins the network whole, full of pore fluid",
          "[structure][fracture]") {
  GrowingRock rock(meeting_case(CrossingRule::never));
  const GrowthPlan plan = grow_until_met(rock);
  CHECK(saturated(plan) == vertices_of(rock.geometry.mesh, "fault"));
  for (const NetworkNode& node : plan.insertion.new_nodes)
    if (node.saturated) CHECK(node.formation_pressure == 3e6);
  for (const FractureVertex& vertex : rock.geometry.mesh.vertices) {
    if (vertex.units.empty()) continue;
    const auto index = static_cast<VertexIndex>(&vertex - rock.geometry.mesh.vertices.data());
    CHECK(rock.geometry.network.contains(index));
  }
  // Neither the faces that were there nor the mouth lose their fluid at the connection.
  const VertexIndex junction = plan.meetings.front().junction;
  REQUIRE(rock.geometry.mesh.vertices[junction].units.size() == 3);
  for (const UnitIndex unit : rock.geometry.mesh.vertices[junction].units)
    CHECK(rock.state.joints.state[unit].pressure == 3e6);
}

TEST_CASE(
    "natural fractures connected to the one that is met join with it, cemented and separate ones do not",
    "[structure][fracture]") {
  Case given = meeting_case(CrossingRule::never);
  add_line(given, "crossing", FractureKind::natural, {-1, 1.5}, {2, 1.5});
  add_line(given, "touching", FractureKind::natural, {2, 1.5}, {2, -1});
  add_line(given, "separate", FractureKind::natural, {5, -1}, {5, 1});
  add_line(given, "cemented", FractureKind::natural, {0, -1}, {1.2, -1.5});
  given.fractures.back().tensile_strength = 3e6;
  given.fractures.back().fracture_energy = 100;
  GrowingRock rock(given);
  const GrowthPlan plan = grow_until_met(rock);
  const auto joined = [&](Point at) {
    return rock.geometry.network.contains(nearest_split_vertex(rock.geometry.mesh, at));
  };
  CHECK(joined({1, 1.5}));
  CHECK(joined({2, 0}));
  CHECK_FALSE(joined({5, 0}));
  CHECK_FALSE(joined({0.8, -1.33}));
}

TEST_CASE("the decision at a meeting is written with its numbers", "[structure][fracture]") {
  GrowingRock rock(meeting_case(CrossingRule::blanton));
  const Meeting meeting = grow_until_met(rock).meetings.front();
  CHECK(meeting.hydraulic == "growth of slit");
  CHECK(meeting.natural == "fault");
  CHECK(meeting.verdict.angle == Approx(std::numbers::pi / 2).margin(0.1));
  const auto json = meetings_json({meeting}).at(0);
  for (const char* key :
       {"time", "x", "y", "hydraulic", "natural", "angle", "stress_xx", "stress_yy", "stress_xy", "friction",
        "cohesion", "strength", "criterion", "critical_friction", "crosses"})
    CHECK(json.contains(key));
  CHECK(json.at("criterion") == "blanton");
  CHECK(json.at("friction") == 0.6);
}

TEST_CASE("a fracture that may cross goes on from the far side of the natural one", "[structure][fracture]") {
  GrowingRock rock(meeting_case(CrossingRule::always));
  const GrowthPlan plan = grow_until_met(rock);
  REQUIRE(rock.state.crossing_seeds.size() == 1);
  const VertexIndex junction = plan.meetings.front().junction;
  CHECK(rock.geometry.mesh.edges[rock.state.crossing_seeds[0].edge].across(junction) != junction);
  const auto before = rock.geometry.network.nodes()[rock.geometry.network.index_of(junction)].lumped_length;
  for (int k = 0; k < 6; ++k) {
    rock.grow_along(0, 1);
    require_sound(rock);
  }
  CHECK(rock.state.crossing_seeds.empty());
  CHECK(rock.geometry.mesh.vertices[junction].units.size() == 4);
  CHECK(easternmost(rock.geometry.mesh) > 1.2);
  CHECK(rock.geometry.network.nodes()[rock.geometry.network.index_of(junction)].lumped_length ==
        Approx(before + rock.h() / 2).epsilon(0.02));
}

TEST_CASE("a fracture that may not cross stays where it met the natural one", "[structure][fracture]") {
  GrowingRock rock(meeting_case(CrossingRule::never));
  grow_until_met(rock);
  CHECK(rock.state.crossing_seeds.empty());
  rock.grow_along(0, 6);
  CHECK(easternmost(rock.geometry.mesh) == 0);
}

TEST_CASE("a natural fracture grows from its ends once it has slid", "[structure][fracture]") {
  GrowingRock rock(meeting_case(CrossingRule::never));
  CHECK(natural_ends(rock.geometry.mesh, rock.state.joints).empty());
  for (JointState& state : rock.state.joints.state) state.slip = 2 * active_slip;
  const auto ends = natural_ends(rock.geometry.mesh, rock.state.joints);
  REQUIRE(ends.size() == 2);
  rock.pull_across(std::numbers::pi / 2);
  const GrowthPlan plan = rock.plan();
  rock.insert(plan);
  require_sound(rock);
  CHECK(vertices_of(rock.geometry.mesh, "growth of fault") >= 1);
  // What it grew has nothing to do with the fluid that is pumped until it is reached.
  for (const FractureTip& end : ends) {
    CHECK_FALSE(rock.geometry.network.contains(end.vertex));
    for (const UnitIndex unit : rock.geometry.mesh.vertices[end.vertex].units)
      CHECK(rock.state.joints.ramp[unit].pressure_end == 3e6);
  }
}

TEST_CASE("the mean direction of a fracture looks past its last segment", "[structure][fracture]") {
  GrowingRock rock(free_slit());
  rock.grow_along(0, 4);
  rock.grow_along(0.5, 1);
  const FractureTip tip = rock.tip_near({6, 0.1});
  const auto last = mean_direction(rock.geometry.mesh, tip, 1),
             mean = mean_direction(rock.geometry.mesh, tip, 5);
  CHECK(std::atan2(last[1], last[0]) == Approx(0.5).margin(0.05));
  CHECK(std::atan2(mean[1], mean[0]) == Approx(0.1).margin(0.03));
}
