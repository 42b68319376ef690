// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "structure/dynamics/triangle.hpp"
#include "structure/fracture/failing_tips.hpp"
#include "structure/fracture/patch_equilibrium.hpp"
#include "structure/structure_run.hpp"
#include "tests/structure/fracture/failing_rock.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

std::vector<ElementIndex> elements_within(const GrowingRock& rock, const Point& centre, double radius) {
  const Mesh& mesh = rock.geometry.mesh;
  std::vector<ElementIndex> elements;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const Point at = centroid(mesh, element);
    if (std::hypot(at[0] - centre[0], at[1] - centre[1]) < radius) elements.push_back(element);
  }
  return elements;
}

bool same_in_situ(const Body& a, const Body& b) {
  return a.in_situ.size() == b.in_situ.size() &&
         std::memcmp(a.in_situ.data(), b.in_situ.data(), a.in_situ.size() * sizeof(InSituElement)) == 0;
}

bool same_groups(const Tiles& a, const Tiles& b) {
  for (std::size_t t = 0; t < a.tile.size(); ++t)
    if (std::memcmp(a.tile[t].groups.data(), b.tile[t].groups.data(),
                    a.tile[t].groups.size() * sizeof(ElementGroup)) != 0 ||
        a.tile[t].out_of_plane != b.tile[t].out_of_plane)
      return false;
  return true;
}

}  // namespace

TEST_CASE("equilibrium of a patch: nodes that were displaced at random return to a uniform strain",
          "[structure][fracture]") {
  GrowingRock rock(free_slit());
  rock.strain_uniformly({1e6, 2e6, 0.5e6});
  const std::vector<double> uniform = rock.state.body.displacement;
  const auto elements = elements_within(rock, {0, 4}, 2);
  const auto inner = inner_nodes(rock.geometry.mesh, rock.geometry.node_elements, elements);
  REQUIRE(inner.size() > 3);
  for (const NodeIndex node : inner) rock.state.body.displacement[2 * node] += 1e-5 * std::sin(node);
  const auto report =
      equilibrate(rock.model, rock.geometry, elements, {}, rock.state.joints, rock.state.body.displacement);
  CHECK(report.converged);
  for (std::size_t k = 0; k < uniform.size(); ++k)
    CHECK(rock.state.body.displacement[k] == Approx(uniform[k]).margin(1e-10));  // 1e-5 of the disturbance
}

TEST_CASE("hand-over: faces take over the strength that is left and the opening of the band",
          "[structure][fracture]") {
  constexpr double share = 0.8;
  GrowingRock rock(failing_slit());
  const double h = rock.h();
  fail(rock, share,
       [&](const Point& at) { return at[0] > 2.5 && at[0] < 2.5 + 3.5 * h && std::abs(at[1]) < 0.7 * h; });
  rock.pull_across(0);
  // The rock above the band has moved away from that below by the opening of the band.
  const CohesiveLaw law{tip_strength(1e6, 50, rock.model.run_case.rock.plane_strain_modulus(), h), 50};
  const double opening = share * law.critical_opening();
  for (std::size_t node = 0; node < rock.geometry.mesh.position.size(); ++node) {
    rock.state.body.displacement[2 * node] = 0;
    rock.state.body.displacement[2 * node + 1] =
        opening * std::clamp(rock.geometry.mesh.position[node][1] / h, -0.5, 0.5);
  }
  const double before = failure_work(rock.model, rock.geometry, rock.state) +
                        cohesive_work(rock.geometry.mesh, rock.state.joints);
  REQUIRE(before > 0);
  const auto records = rock.insert(rock.plan());
  REQUIRE(records.size() == 1);
  CHECK(records[0].hash_before == records[0].hash_after);

  const double after = failure_work(rock.model, rock.geometry, rock.state) +
                       cohesive_work(rock.geometry.mesh, rock.state.joints);
  CHECK(after == Approx(before).epsilon(1e-12));  // a sum in another order
  const FailureMap left = map(rock);
  int inside = 0;
  for (const FractureVertex& vertex : rock.geometry.mesh.vertices) {
    const double along = (vertex.position[0] - 2.5) / h;
    if (along < 0.5 || vertex.units.empty()) continue;
    ++inside;
    const JointState& joint = rock.state.joints.state[vertex.units[0]];
    CHECK(joint.greatest_separation >=
          0.999 * share * rock.state.joints.properties[vertex.units[0]].cohesive.critical_opening());
    CHECK(joint.opening ==
          Approx(opening).epsilon(0.25));  // the last of them is next to the tip, where nothing opens
  }
  CHECK(inside == 3);
  for (const ElementIndex element : left.failed(0.1)) {
    const Point at = centroid(rock.geometry.mesh, element);
    CHECK((std::abs(at[1]) > h || at[0] > 2.5 + 3.2 * h));
  }
}

TEST_CASE("wet zone: the total stress of undamaged rock stays, a crack transmits the pressure of the fluid",
          "[structure][fracture]") {
  constexpr double fluid = 20e6;
  Case given = failing_slit();
  given.in_situ.stress = {-10e6, -8e6, 1e6, -12e6};
  given.in_situ.pore_pressure = 3e6;
  GrowingRock rock(given);
  const Body before = rock.geometry.body;
  const Tiles tiles = rock.geometry.tiles;
  for (JointState& joint : rock.state.joints.state) {
    joint.pressure = fluid;
    joint.closed = false;
  }
  WetZone zone;
  zone.refresh(rock.model, map(rock), {}, rock.state, rock.geometry);
  std::size_t wet = 0;
  for (ElementIndex element = 0; element < before.in_situ.size(); ++element) {
    const InSituElement &was = before.in_situ[element], &is = rock.geometry.body.in_situ[element];
    if (is.pore_pressure == was.pore_pressure) continue;
    ++wet;
    const Point at = centroid(rock.geometry.mesh, element);
    CHECK(std::hypot(std::abs(at[0]) - 2.5, at[1]) < (given.growth.wet_zone + 1) * rock.h());
    CHECK(is.pore_pressure == Approx(fluid));
    CHECK(is.xx - is.pore_pressure == Approx(was.xx - was.pore_pressure));
    CHECK(is.yy - is.pore_pressure == Approx(was.yy - was.pore_pressure));
    CHECK(is.xy == was.xy);
    const PlaneStrainStress crack = transmitted_stress({{is.xx, is.yy, is.xy}, is.zz}, 1);
    CHECK(crack.in_plane.xx - is.pore_pressure == Approx(-fluid));
    CHECK(crack.in_plane.yy - is.pore_pressure == Approx(-fluid));
  }
  CHECK(wet > 10);
  const Tiles rebuilt = build_tiles(rock.geometry.mesh, rock.geometry.body, rock.geometry.joint_nodes);
  CHECK(same_groups(rock.geometry.tiles, rebuilt));
  CHECK_FALSE(same_groups(rock.geometry.tiles, tiles));

  SECTION("dried") {
    zone.dry(rock.model, rock.geometry);
  }
  SECTION("left by the fluid") {
    for (JointState& joint : rock.state.joints.state) joint.pressure = 0;
    zone.refresh(rock.model, map(rock), {}, rock.state, rock.geometry);
  }
  CHECK(same_in_situ(rock.geometry.body, before));
  CHECK(same_groups(rock.geometry.tiles, tiles));
}

TEST_CASE("a nucleated fracture has faces in its middle, two tips and a part of the network of its own",
          "[structure][fracture]") {
  Case given = failing_slit();
  given.mesh.refinements = {{0.25, -2.5, 2.5, 1, 7}};
  GrowingRock rock(given);
  const double h = rock.h();
  fail(rock, 0.8, [&](const Point& at) { return std::abs(at[0]) < 2.5 * h && std::abs(at[1] - 4) < h; });
  rock.pull_across(0);
  for (double& u : rock.state.body.displacement) u *= 0.01;
  const std::size_t tips = fracture_tips(rock.geometry.mesh).size(),
                    nodes = rock.geometry.network.nodes().size();
  const GrowthPlan plan = rock.plan();
  const auto records = rock.insert(plan);
  REQUIRE(records.size() == 1);
  CHECK(records[0].fracture == "nucleated 1");
  CHECK(fracture_tips(rock.geometry.mesh).size() == tips + 2);
  CHECK(rock.geometry.network.nodes().size() > nodes);
  CHECK(plan.insertion.parents.empty());
  for (const NetworkNode& node : plan.insertion.new_nodes) CHECK(std::abs(node.y - 4) < 2 * h);
}
