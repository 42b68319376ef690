// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "structure/dynamics/triangle.hpp"
#include "tests/structure/fracture/growing_rock.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

bool grows(const GrowingRock& rock) {
  return plan_growth(rock.model, rock.geometry, rock.state, 0).has_value();
}

/// Uniaxial tension across the slit.
void pull(GrowingRock& rock, double stress) {
  rock.strain_uniformly({0, stress, 0});
}

void pressurise(GrowingRock& rock, double pressure) {
  for (JointState& state : rock.state.joints.state) {
    state.pressure = pressure;
    state.closed = false;
  }
}

std::set<NodeIndex> nodes_of(const GrowingRock& rock, const PatchPlan& patch) {
  std::set<NodeIndex> nodes;
  for (const ElementIndex element : patch.removed)
    nodes.insert(rock.geometry.mesh.elements[element].begin(), rock.geometry.mesh.elements[element].end());
  return nodes;
}

}  // namespace

TEST_CASE("a tip advances when the mean stress ahead reaches its share of the strength",
          "[structure][fracture]") {
  GrowingRock rock(free_slit());
  const double strength = rock.model.run_case.rock.tensile_strength;
  pull(rock, 0.649 * strength);
  CHECK_FALSE(grows(rock));
  pull(rock, 0.651 * strength);
  CHECK(grows(rock));
  rock.model.run_case.growth.trigger = 0.9;
  CHECK_FALSE(grows(rock));
}

TEST_CASE("the strength at a tip is what elements of that size can carry", "[structure][fracture]") {
  GrowingRock rock(free_slit());
  rock.model.run_case.rock.fracture_energy = 1;
  const double strength = std::sqrt(rock.model.run_case.rock.plane_strain_modulus() * 1 / (1.5 * rock.h()));
  REQUIRE(strength < 0.5 * rock.model.run_case.rock.tensile_strength);
  pull(rock, 0.649 * strength);
  CHECK_FALSE(grows(rock));
  pull(rock, 0.651 * strength);
  CHECK(grows(rock));
}

TEST_CASE("fluid next to the tip counts as much as tension", "[structure][fracture]") {
  Case given = free_slit();
  given.in_situ.stress = {-7e6, -5e6, 0, -5e6};
  GrowingRock rock(given);
  const double threshold = 5e6 + 0.65 * given.rock.tensile_strength;
  pressurise(rock, 0.999 * threshold);
  CHECK_FALSE(grows(rock));
  pressurise(rock, 1.001 * threshold);
  CHECK(grows(rock));
}

TEST_CASE("the pressure next to a tip is the least behind it, and none where the faces touch",
          "[structure][fracture]") {
  GrowingRock rock(free_slit());
  const Mesh& mesh = rock.geometry.mesh;
  pressurise(rock, 6e6);
  const FractureTip tip = rock.tip_near({2.5, 0});
  const auto at = [&](double x) -> JointState& {
    return rock.state.joints.state[mesh.vertices[nearest_split_vertex(mesh, {x, 0})].units[0]];
  };
  CHECK(adjacent_pressure(mesh, rock.state.joints, tip) == 6e6);
  at(0).pressure = 1e6;  // far behind
  CHECK(adjacent_pressure(mesh, rock.state.joints, tip) == 6e6);
  at(2).pressure = 5e6;
  CHECK(adjacent_pressure(mesh, rock.state.joints, tip) == 5e6);
  at(2.3).closed = true;
  CHECK(adjacent_pressure(mesh, rock.state.joints, tip) == 0);
}

TEST_CASE("the pressure of the pores counts at a tip where the fluid has not arrived",
          "[structure][fracture]") {
  Case given = free_slit();
  given.in_situ.stress = {-2e6, -1e6, 0, -1e6};
  given.in_situ.pore_pressure = 8e6;
  GrowingRock rock(given);
  pull(rock, 1.6e6);  // 0.6 MPa effective
  CHECK_FALSE(grows(rock));
  pull(rock, 1.7e6);
  CHECK(grows(rock));
}

TEST_CASE("the network grows by the tips that were, from the vertices before them", "[structure][fracture]") {
  GrowingRock rock(free_slit());
  rock.pull_across(0);
  const auto tips = fracture_tips(rock.geometry.mesh);
  REQUIRE(tips.size() == 2);
  const GrowthPlan plan = rock.plan();
  CHECK(plan.insertion.revision == 1);
  REQUIRE(plan.insertion.new_nodes.size() == 2);
  CHECK(plan.insertion.new_segments.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(plan.insertion.new_nodes[k].id == tips[k].vertex);
    CHECK(plan.insertion.new_nodes[k].role == NodeRole::tip);
    CHECK(plan.insertion.parents[k].node == tips[k].vertex);
    CHECK(plan.insertion.parents[k].parent == tips[k].previous);
    // Half of the edge behind and half of the new one.
    const double behind =
        std::abs(tips[k].position[0] - rock.geometry.mesh.vertices[tips[k].previous].position[0]);
    CHECK(plan.insertion.new_nodes[k].lumped_length == Approx((behind + rock.h()) / 2).epsilon(1e-12));
  }
}

TEST_CASE("what grows from a fracture is one more line, with the strength of the rock",
          "[structure][fracture]") {
  GrowingRock rock(free_slit());
  rock.pull_across(0);
  const GrowthPlan first = rock.plan();
  REQUIRE(first.new_lines.size() == 1);
  CHECK(first.new_lines[0].name == "growth of slit");
  CHECK(first.new_lines[0].kind == FractureKind::intact);
  CHECK(first.new_lines[0].tensile_strength == rock.model.run_case.rock.tensile_strength);
  CHECK(first.new_lines[0].fracture_energy == rock.model.run_case.rock.fracture_energy);
  for (const PatchPlan& patch : first.patches) CHECK(patch.new_edges.at(0).line == 1);
  rock.insert(first);
  rock.pull_across(0);
  const GrowthPlan second = rock.plan();
  CHECK(second.new_lines.empty());
  for (const PatchPlan& patch : second.patches) CHECK(patch.new_edges.at(0).line == 1);
}

TEST_CASE("patches of one coupling time share no node; the tip that has to wait grows at the next",
          "[structure][fracture]") {
  Case given = free_case(16);
  add_line(given, "west", FractureKind::open, {-4, 0}, {-0.6, 0});
  add_line(given, "east", FractureKind::open, {0.6, 0.2}, {4, 0.2});
  GrowingRock rock(given);
  std::size_t waited = 0, segments = 0;
  for (int k = 0; k < 3; ++k) {
    rock.pull_across(0);
    const GrowthPlan plan = rock.plan();
    waited += fracture_tips(rock.geometry.mesh).size() - plan.patches.size();
    for (std::size_t a = 0; a < plan.patches.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) {
        const auto first = nodes_of(rock, plan.patches[a]), second = nodes_of(rock, plan.patches[b]);
        CHECK(
            std::none_of(first.begin(), first.end(), [&](NodeIndex node) { return second.contains(node); }));
      }
    segments += rock.insert(plan).size();
  }
  CHECK(waited >= 1);
  CHECK(segments >= 7);
}

TEST_CASE("natural fractures do not grow from their ends", "[structure][fracture]") {
  Case given = free_case(16);
  add_line(given, "fault", FractureKind::natural, {-2, 0}, {2, 1});
  add_line(given, "slit", FractureKind::open, {-2, 4}, {2, 4});
  const GrowingRock rock(given);
  for (const FractureTip& tip : fracture_tips(rock.geometry.mesh)) CHECK(tip.position[1] > 3);
}

TEST_CASE("no damage may start around the tips that grow", "[structure][fracture]") {
  const GrowingRock rock(free_slit());
  const auto elements = tip_surroundings(rock.model, rock.geometry, rock.state.joints);
  REQUIRE(std::is_sorted(elements.begin(), elements.end()));
  const double reach = rock.model.run_case.bulk_failure.tip_exclusion * rock.h();
  const Mesh& mesh = rock.geometry.mesh;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const Point at = centroid(mesh, element);
    const double away = std::hypot(std::abs(at[0]) - 2.5, at[1]);
    const bool listed = std::binary_search(elements.begin(), elements.end(), element);
    if (away < 0.8 * reach) CHECK(listed);
    if (away > 1.5 * reach) CHECK_FALSE(listed);
  }
}

TEST_CASE("the ledger of a remeshing says what the coupler is promised", "[structure][fracture]") {
  GrowingRock rock(free_slit());
  rock.pull_across(0);
  const GrowthPlan plan = rock.plan();
  const std::size_t elements = rock.geometry.mesh.elements.size();
  const auto records = rock.insert(plan);
  REQUIRE(records.size() == plan.patches.size());
  std::size_t removed = 0, made = 0;
  for (std::size_t k = 0; k < records.size(); ++k) {
    CHECK(records[k].fracture == "growth of slit");
    CHECK(records[k].tip == plan.patches[k].tip);
    CHECK(records[k].hash_before == records[k].hash_after);
    CHECK_FALSE(records[k].hash_before.empty());
    CHECK(records[k].stable_step_after >= 0.5 * records[k].stable_step_before);
    CHECK(records[k].smallest_altitude > 0.4 * rock.h() * (1 - 1e-9));
    removed += records[k].removed;
    made += records[k].made;
  }
  CHECK(rock.geometry.mesh.elements.size() == elements - removed + made);
  CHECK(records[0].untouched <= elements - removed);
  CHECK(records[0].untouched > elements - removed - 20 * records.size());  // what is rewired stays small

  const nlohmann::json json = remeshing_json(records);
  REQUIRE(json.size() == records.size());
  for (const char* key :
       {"fracture", "x", "y", "elements_removed", "elements_made", "elements_untouched", "hash_before",
        "hash_after", "smallest_angle", "smallest_altitude", "stable_step_before", "stable_step_after",
        "strain_energy_before", "strain_energy_after", "kinetic_energy_before", "kinetic_energy_after",
        "mass_error", "momentum_error", "wall_seconds"})
    CHECK(json[0].contains(key));
}
