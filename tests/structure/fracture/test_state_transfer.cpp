// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>
#include <set>

#include "structure/dynamics/energy.hpp"
#include "structure/dynamics/triangle.hpp"
#include "tests/structure/fracture/growing_rock.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

void shake(GrowingRock& rock) {
  std::mt19937_64 random(7);
  for (double& velocity : rock.state.body.velocity)
    velocity = static_cast<double>(random() >> 11) * 0x1p-53 - 0.4;
}

std::array<double, 2> momentum_of(const GrowingRock& rock, double west, double east) {
  std::array<double, 2> sum{};
  for (std::size_t node = 0; node < rock.geometry.mesh.position.size(); ++node) {
    if (rock.geometry.mesh.position[node][0] < west || rock.geometry.mesh.position[node][0] > east) continue;
    for (std::size_t axis = 0; axis < 2; ++axis)
      sum[axis] += rock.geometry.body.mass[node] * rock.state.body.velocity[2 * node + axis];
  }
  return sum;
}

constexpr double everywhere = 1e9;

}  // namespace

TEST_CASE("mass and momentum stay the same over an insertion", "[structure][fracture]") {
  GrowingRock rock(free_slit());
  rock.pull_across(0.2);
  shake(rock);
  const double mass = std::accumulate(rock.geometry.body.mass.begin(), rock.geometry.body.mass.end(), 0.0);
  const auto before = momentum_of(rock, -everywhere, everywhere);
  const auto records = rock.insert(rock.plan());
  const auto after = momentum_of(rock, -everywhere, everywhere);
  CHECK(std::accumulate(rock.geometry.body.mass.begin(), rock.geometry.body.mass.end(), 0.0) ==
        Approx(mass).epsilon(1e-14));
  for (int axis = 0; axis < 2; ++axis)
    CHECK(std::abs(after[axis] - before[axis]) < 1e-13 * mass);  // speeds of the order of 1
  for (const RemeshRecord& record : records) {
    CHECK(record.mass_error < 1e-14);
    CHECK(record.momentum_error < 1e-13);
  }
}

TEST_CASE("every patch keeps its own momentum", "[structure][fracture]") {
  GrowingRock rock(free_slit());
  rock.pull_across(0.2);
  for (std::size_t node = 0; node < rock.geometry.mesh.position.size(); ++node)
    if (const Point& at = rock.geometry.mesh.position[node]; at[0] > 0) {
      rock.state.body.velocity[2 * node] = std::sin(9 * at[0]) * std::cos(7 * at[1]);
      rock.state.body.velocity[2 * node + 1] = std::sin(8 * at[0] + 6 * at[1]);
    }
  const GrowthPlan plan = rock.plan();
  REQUIRE(plan.patches.size() == 2);
  rock.insert(plan);
  for (std::size_t node = 0; node < rock.geometry.mesh.position.size(); ++node)
    if (rock.geometry.mesh.position[node][0] < 0) {
      REQUIRE(rock.state.body.velocity[2 * node] == 0);
      REQUIRE(rock.state.body.velocity[2 * node + 1] == 0);
    }
}

TEST_CASE("a rigid motion and a uniform strain pass through an insertion", "[structure][fracture]") {
  GrowingRock rock(free_slit());
  rock.pull_across(-0.3);
  for (std::size_t node = 0; node < rock.geometry.mesh.position.size(); ++node) {
    rock.state.body.velocity[2 * node] = 0.3;
    rock.state.body.velocity[2 * node + 1] = -0.2;
  }
  const double energy = strain_energy(rock.geometry.mesh, rock.model.moduli, rock.state.body.displacement);
  const InPlane<double> strain_before =
      strain(rock.geometry.mesh, 0, triangle(rock.geometry.mesh, 0), rock.state.body.displacement);
  const auto records = rock.insert(rock.plan());
  const Mesh& mesh = rock.geometry.mesh;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const InPlane<double> now = strain(mesh, element, triangle(mesh, element), rock.state.body.displacement);
    REQUIRE(std::abs(now.xx - strain_before.xx) + std::abs(now.yy - strain_before.yy) +
                std::abs(now.xy - strain_before.xy) <
            1e-15);
  }
  CHECK(strain_energy(mesh, rock.model.moduli, rock.state.body.displacement) ==
        Approx(energy).epsilon(1e-10));
  for (const RemeshRecord& record : records) {
    CHECK(record.strain_energy_after == Approx(record.strain_energy_before).epsilon(1e-10));
    CHECK(record.kinetic_energy_after == Approx(record.kinetic_energy_before).epsilon(1e-10));
  }
  std::set<NodeIndex> unused(mesh.unused_nodes.begin(), mesh.unused_nodes.end());
  for (NodeIndex node = 0; node < mesh.position.size(); ++node) {
    if (unused.contains(node)) continue;
    REQUIRE(rock.state.body.velocity[2 * node] == Approx(0.3).epsilon(1e-12));
    REQUIRE(rock.state.body.velocity[2 * node + 1] == Approx(-0.2).epsilon(1e-12));
  }
}

TEST_CASE("both sides of a split node move on as it did, and what is not in a patch keeps its bits",
          "[structure][fracture]") {
  GrowingRock rock(free_slit());
  rock.pull_across(0);
  shake(rock);
  const FractureTip tip = rock.tip_near({2.5, 0});
  const GrowthPlan plan = rock.plan();
  const State before = rock.state.body;
  const std::vector<Point> position = rock.geometry.mesh.position;
  rock.insert(plan);

  const FractureVertex& split = rock.geometry.mesh.vertices[tip.vertex];
  REQUIRE(split.units.size() == 1);
  const ContactUnit& unit = rock.geometry.mesh.units[split.units[0]];
  for (const NodeIndex node : {unit.minus, unit.plus})
    for (std::size_t axis = 0; axis < 2; ++axis) {
      CHECK(rock.state.body.displacement[2 * node + axis] == before.displacement[2 * tip.node + axis]);
      CHECK(rock.state.body.velocity[2 * node + axis] == before.velocity[2 * tip.node + axis]);
    }
  std::size_t kept = 0;
  for (NodeIndex node = 0; node < position.size(); ++node) {
    if (rock.geometry.mesh.position[node] != position[node] || rock.geometry.node_elements.of(node).empty())
      continue;
    REQUIRE(std::memcmp(&rock.state.body.displacement[2 * node], &before.displacement[2 * node],
                        2 * sizeof(double)) == 0);
    REQUIRE(std::memcmp(&rock.state.body.velocity[2 * node], &before.velocity[2 * node],
                        2 * sizeof(double)) == 0);
    ++kept;
  }
  CHECK(kept > position.size() - 60);
}

TEST_CASE("a place without a node has no motion", "[structure][fracture]") {
  GrowingRock rock(free_slit());
  rock.model.run_case.mesh.tip_size = 0.33;
  rock.pull_across(0);
  shake(rock);
  rock.insert(rock.plan());
  REQUIRE_FALSE(rock.geometry.mesh.unused_nodes.empty());
  for (const NodeIndex node : rock.geometry.mesh.unused_nodes)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      CHECK(rock.state.body.displacement[2 * node + axis] == 0);
      CHECK(rock.state.body.velocity[2 * node + axis] == 0);
    }
}

TEST_CASE("a unit parted by a junction hands its history to both parts; the new one is a fresh break",
          "[structure][fracture]") {
  GrowingRock rock(slit_before_natural_fracture());
  const UnitIndex units_before = static_cast<UnitIndex>(rock.state.joints.state.size());
  for (UnitIndex unit = 0; unit < units_before; ++unit)
    rock.state.joints.state[unit].greatest_separation = 1e-6 * (unit + 1);
  for (int k = 0; k < 8 && fracture_tips(rock.geometry.mesh).size() > 1; ++k) rock.grow_along(0, 1);
  const Mesh& mesh = rock.geometry.mesh;
  for (const FractureVertex& vertex : mesh.vertices) {
    if (vertex.units.size() != 3) continue;
    const UnitIndex old = *std::min_element(vertex.units.begin(), vertex.units.end());
    REQUIRE(old < units_before);
    int histories = 0, fresh = 0;
    for (const UnitIndex unit : vertex.units) {
      const double separation = rock.state.joints.state[unit].greatest_separation;
      histories += separation == 1e-6 * (old + 1) ? 1 : 0;
      if (separation != 0) continue;
      ++fresh;
      CHECK(rock.state.joints.properties[unit].kind == FractureKind::intact);
      CHECK(rock.state.joints.properties[unit].cohesive.strength > 0);
      CHECK(rock.state.joints.properties[unit].cohesive.fracture_energy ==
            rock.model.run_case.rock.fracture_energy);
      CHECK(rock.state.joints.released[unit] == 1);
      CHECK(rock.state.joints.state[unit].closed);
    }
    CHECK(histories == 2);
    CHECK(fresh == 1);
    return;
  }
  FAIL("no junction");
}
