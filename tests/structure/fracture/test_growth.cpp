// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <numeric>
#include <random>

#include "tests/structure/fracture/growing_rock.hpp"
#include "tests/structure/fracture/mesh_faults.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

constexpr double degree = std::numbers::pi / 180;

void require_sound_mesh(const GrowingRock& rock) {
  const auto faults = mesh_faults(rock.geometry.mesh, rock.model.run_case.domain);
  for (const std::string& fault : faults) UNSCOPED_INFO(fault);
  REQUIRE(faults.empty());
}

void require_everything_built_from_the_mesh(const GrowingRock& rock) {
  const Mesh& mesh = rock.geometry.mesh;
  const NodeElements elements(mesh);
  for (NodeIndex node = 0; node < mesh.position.size(); ++node) {
    const auto kept = rock.geometry.node_elements.of(node), built = elements.of(node);
    REQUIRE(std::equal(kept.begin(), kept.end(), built.begin(), built.end()));
  }
  // Sums in another order: rounding only.
  const Body fresh = build_body(mesh, rock.model.run_case);
  const double force_scale = 1e6 * rock.model.run_case.mesh.far_size;
  for (std::size_t n = 0; n < fresh.mass.size(); ++n) {
    REQUIRE(std::abs(rock.geometry.body.mass[n] - fresh.mass[n]) <= 1e-12 * fresh.mass[n]);
    for (int axis = 0; axis < 2; ++axis)
      REQUIRE(std::abs(rock.geometry.body.external_force[2 * n + axis] -
                       fresh.external_force[2 * n + axis]) <= 1e-12 * force_scale);
  }
  REQUIRE(std::memcmp(rock.geometry.body.in_situ.data(), fresh.in_situ.data(),
                      fresh.in_situ.size() * sizeof(InSituElement)) == 0);
  REQUIRE(rock.geometry.joint_nodes == joint_nodes(mesh));

  const Tiles& tiles = rock.geometry.tiles;
  std::vector<int> holders(mesh.elements.size(), 0);
  for (const Tile& tile : tiles.tile)
    for (const ElementIndex element : tile.elements) ++holders.at(element);
  REQUIRE(std::all_of(holders.begin(), holders.end(), [](int count) { return count == 1; }));
  std::map<NodeIndex, int> owners;
  for (const Tile& tile : tiles.tile)
    for (std::size_t i = 0; i < tile.interior.size(); ++i) ++owners[tile.nodes[i]];
  for (const NodeIndex node : tiles.shared.node) ++owners[node];
  for (const NodeIndex node : tiles.joint.node) ++owners[node];
  REQUIRE(owners.size() == mesh.position.size() - mesh.unused_nodes.size());
  REQUIRE(std::all_of(owners.begin(), owners.end(), [](const auto& owner) { return owner.second == 1; }));

  const Joints& joints = rock.state.joints;
  REQUIRE(joints.properties.size() == mesh.units.size());
  REQUIRE(joints.state.size() == mesh.units.size());
  REQUIRE(joints.released.size() == mesh.units.size());
  REQUIRE(joints.ramp.size() == mesh.units.size());
  REQUIRE(rock.state.body.displacement.size() == 2 * mesh.position.size());
  REQUIRE(rock.state.body.velocity.size() == 2 * mesh.position.size());
}

void require_sound(const GrowingRock& rock) {
  require_sound_mesh(rock);
  require_everything_built_from_the_mesh(rock);
}

double length_of(const Mesh& mesh) {
  return std::accumulate(mesh.edges.begin(), mesh.edges.end(), 0.0,
                         [](double sum, const FractureEdge& edge) { return sum + edge.length; });
}

}  // namespace

TEST_CASE("thirty straight segments leave a mesh, and everything built from it, as if it had been built so",
          "[structure][fracture]") {
  GrowingRock rock(free_slit());
  require_sound_mesh(rock);
  const double before = length_of(rock.geometry.mesh);
  const double mass = std::accumulate(rock.geometry.body.mass.begin(), rock.geometry.body.mass.end(), 0.0);
  // Patches that refine may meet: then one tip waits.
  std::size_t segments = 0;
  while (segments < 30) {
    const std::size_t more = rock.grow_along(0, 1);
    REQUIRE(more >= 1);
    segments += more;
    require_sound(rock);
  }
  const Mesh& mesh = rock.geometry.mesh;
  CHECK(length_of(mesh) == Approx(before + static_cast<double>(segments) * rock.h()).epsilon(1e-12));
  CHECK(std::accumulate(rock.geometry.body.mass.begin(), rock.geometry.body.mass.end(), 0.0) ==
        Approx(mass).epsilon(1e-14));
  // Face vectors point from minus to plus, up or down: a line that grew towards -x has its left side below.
  double face = 0;
  for (const ContactUnit& unit : mesh.units) {
    face += std::abs(unit.face[1]);
    REQUIRE(std::abs(unit.face[0]) < 1e-9);
  }
  CHECK(face ==
        Approx(length_of(mesh) - rock.h()).epsilon(1e-9));  // all but the outer halves of the last two edges
  for (const FractureVertex& vertex : mesh.vertices) CHECK(std::abs(vertex.position[1]) < 1e-9);
}

TEST_CASE("a fracture that turns again and again leaves a sound mesh", "[structure][fracture]") {
  GrowingRock rock(free_slit());
  const double step = GENERATE(4.0, 25.0, -60.0);
  for (int k = 0; k < 5; ++k) {
    REQUIRE(rock.grow_along((k % 2 == 0 ? 1 : -0.5) * step * degree, 1) >= 1);
    require_sound(rock);
  }
}

TEST_CASE("a coarse background refines itself as the tips arrive", "[structure][fracture]") {
  Case given = free_slit();
  given.mesh.fracture_size = 1;
  given.mesh.far_size = 2;
  GrowingRock rock(given);
  const std::size_t before = rock.geometry.mesh.elements.size();
  for (int k = 0; k < 14; ++k) {
    REQUIRE(rock.grow_along(0, 1) >= 1);
    require_sound(rock);
  }
  const Mesh& mesh = rock.geometry.mesh;
  CHECK(mesh.elements.size() > before);
  CHECK(mesh.elements.size() < 4000);
  for (const FractureTip& tip : fracture_tips(mesh))
    for (const ElementIndex element : rock.geometry.node_elements.of(tip.node))
      CHECK(std::sqrt(4 / std::numbers::sqrt3 * element_area(mesh, element)) < 1.3 * rock.h());
}

TEST_CASE("a fracture that runs into another joins it at one of its vertices", "[structure][fracture]") {
  GrowingRock rock(slit_before_natural_fracture());
  const auto joined = [&] { return fracture_tips(rock.geometry.mesh).size() == 1; };
  for (int k = 0; k < 8 && !joined(); ++k) {
    REQUIRE(rock.grow_along(0, 1) >= 1);
    require_sound(rock);
  }
  REQUIRE(joined());
  const Mesh& mesh = rock.geometry.mesh;
  const auto junction = std::find_if(mesh.vertices.begin(), mesh.vertices.end(),
                                     [](const FractureVertex& vertex) { return vertex.units.size() == 3; });
  REQUIRE(junction != mesh.vertices.end());
  CHECK(junction->position[0] == 0);
  CHECK(std::abs(junction->position[1]) < 0.75 * rock.h());
  // The units share the junction's nodes: three nodes, each in two units.
  std::map<NodeIndex, int> uses;
  for (const UnitIndex unit : junction->units) {
    ++uses[mesh.units[unit].minus];
    ++uses[mesh.units[unit].plus];
  }
  CHECK(uses.size() == 3);
  for (const auto& [node, count] : uses) CHECK(count == 2);
  // The tip is gone; that on the other side goes on.
  REQUIRE(rock.grow_along(0, 2) == 2);
  require_sound(rock);
}

TEST_CASE("two fractures that run into a third from both sides at one place cross it",
          "[structure][fracture]") {
  GrowingRock rock(slits_on_both_sides());
  for (int k = 0; k < 12; ++k) {
    rock.grow_along(0, 1);
    require_sound(rock);
  }
  const Mesh& mesh = rock.geometry.mesh;
  std::vector<std::size_t> degree(mesh.vertices.size(), 0);
  for (const FractureEdge& edge : mesh.edges) {
    ++degree[edge.begin];
    ++degree[edge.end];
  }
  const auto crossing = std::find(degree.begin(), degree.end(), 4);
  REQUIRE(crossing != degree.end());
  CHECK(mesh.vertices[static_cast<std::size_t>(crossing - degree.begin())].units.size() == 4);
  CHECK(fracture_tips(mesh).size() == 2);
}

TEST_CASE("two fractures on one line become one", "[structure][fracture]") {
  Case given = free_case(16);
  add_line(given, "west", FractureKind::open, {-5, 0}, {-1.5, 0});
  add_line(given, "east", FractureKind::open, {1.4, 0}, {5, 0});
  GrowingRock rock(given);
  for (int k = 0; k < 16 && fracture_tips(rock.geometry.mesh).size() > 2; ++k) {
    rock.grow_along(0, 1);
    require_sound(rock);
  }
  const std::vector<FractureTip> tips = fracture_tips(rock.geometry.mesh);
  REQUIRE(tips.size() == 2);
  CHECK(std::abs(tips[0].position[0]) > 5);
  CHECK(std::abs(tips[1].position[0]) > 5);
  // From tip to tip without a gap.
  CHECK(length_of(rock.geometry.mesh) ==
        Approx(std::abs(tips[1].position[0] - tips[0].position[0])).epsilon(1e-9));
}

TEST_CASE("a fracture that meets another one beside its tip joins it", "[structure][fracture]") {
  Case given = free_case(16);
  add_line(given, "long", FractureKind::open, {-3, -0.3}, {3, 0.4});
  add_line(given, "short", FractureKind::open, {0.2, 1.2}, {0.2, 3});
  GrowingRock rock(given);
  for (int k = 0; k < 8 && fracture_tips(rock.geometry.mesh).size() > 3; ++k) {
    rock.grow_along(90 * degree, 1);
    require_sound(rock);
  }
  CHECK(fracture_tips(rock.geometry.mesh).size() == 3);
  // The junction was wet before: nothing of it is held any more.
  for (const std::uint8_t released : rock.state.joints.released) CHECK(released == 1);
}

TEST_CASE("a fracture breaks through to a side of the domain", "[structure][fracture]") {
  Case given = free_case(16);
  add_line(given, "slit", FractureKind::open, {-7, 0.1}, {-4, 0.1});
  given.mesh.refinements = {{0.25, -8, -6, -1, 1}};
  GrowingRock rock(given);
  for (int k = 0; k < 12 && fracture_tips(rock.geometry.mesh).size() > 1; ++k) {
    rock.grow_along(0, 1);
    require_sound(rock);
  }
  REQUIRE(fracture_tips(rock.geometry.mesh).size() == 1);
  const Mesh& mesh = rock.geometry.mesh;
  const auto mouth = std::find_if(mesh.vertices.begin(), mesh.vertices.end(),
                                  [](const FractureVertex& vertex) { return vertex.position[0] == -8; });
  REQUIRE(mouth != mesh.vertices.end());
  CHECK(mouth->units.size() == 1);
}

TEST_CASE("fractures that grow from everywhere at once leave a sound mesh", "[structure][fracture]") {
  Case given = free_case(20);
  add_line(given, "a", FractureKind::open, {-6, -3}, {-4, -2});
  add_line(given, "b", FractureKind::open, {3, 3}, {5, 1.5});
  add_line(given, "c", FractureKind::open, {-5, 4}, {-5, 6});
  add_line(given, "d", FractureKind::natural, {-2, -5}, {1, 5});
  add_line(given, "e", FractureKind::open, {3, -4}, {5, -4});
  GrowingRock rock(given);
  std::size_t segments = 0;
  for (int k = 0; k < 16; ++k) {
    segments += rock.grow_along((20 * k - 60) * degree, 1);
    require_sound(rock);
  }
  CHECK(segments > 60);
}

TEST_CASE("random fractures grow on random paths and leave a sound mesh", "[structure][fracture]") {
  const std::uint64_t seed = GENERATE(1, 2, 3, 4);
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  Case given = free_case(16);
  given.mesh.seed = seed;
  given.mesh.far_size = uniform(0.5, 1.5);
  given.mesh.fracture_size = uniform(0.25, 1);
  for (int k = 0; k < 4; ++k) {
    const double x = -3 + 6 * (k % 2) + uniform(-1, 1), y = -3 + 6 * (k / 2) + uniform(-1, 1),
                 angle = uniform(0, 6);
    add_line(given, std::string(1, static_cast<char>('a' + k)),
             k == 1 ? FractureKind::natural : FractureKind::open, {x - std::cos(angle), y - std::sin(angle)},
             {x + std::cos(angle), y + std::sin(angle)});
  }
  GrowingRock rock(given);
  require_sound_mesh(rock);
  std::size_t segments = 0;
  double angle = uniform(0, 3);
  for (int k = 0; k < 10; ++k) {
    segments += rock.grow_along(angle += uniform(-0.5, 0.5), 1);
    require_sound_mesh(rock);
  }
  require_sound(rock);
  CHECK(segments > 15);
}
