// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "structure/initial_motion.hpp"
#include "structure/structure_probes.hpp"
#include "tests/structure/fracture/growing_rock.hpp"

/// What probes see, and what moves at time 0.

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

constexpr double pull = 1e6, length = 4;  // [Pa], [m]

/// A slit in rock with an in-situ stress.
Case slit_in_rock() {
  Case given = free_slit();
  given.in_situ.stress = {-3e6, -5e6, 1e6, 0};
  given.output.probes = {{"off", {-3.3, 2.1}}, {"above", {0.1, 0.15}}, {"below", {0.1, -0.15}}};
  return given;
}

/// Displaces every node so that the strain eps_yy is pull / M (y / length)^2.
void bend(GrowingRock& rock, double modulus) {
  for (std::size_t node = 0; node < rock.geometry.mesh.position.size(); ++node) {
    const double y = rock.geometry.mesh.position[node][1];
    rock.state.body.displacement[2 * node + 1] = pull / modulus * y * y * y / (3 * length * length);
  }
}

}  // namespace

TEST_CASE("a probe sees a uniform stress exactly, in situ and change together", "[verification][structure]") {
  GrowingRock rock(slit_in_rock());
  rock.strain_uniformly({2e6, -1e6, 0.5e6});
  Probes probes(rock.model.run_case.output.probes);
  for (const ProbeValues& seen : probes.observe(rock.model, rock.geometry, rock.state)) {
    // In-situ stresses are stored in single precision.
    CHECK(seen.stress.xx == Approx(-1e6).epsilon(1e-5));
    CHECK(seen.stress.yy == Approx(-6e6).epsilon(1e-5));
    CHECK(seen.stress.xy == Approx(1.5e6).epsilon(1e-5));
  }
}

TEST_CASE("a probe sees the stress at its place, not that of its triangle", "[verification][structure]") {
  GrowingRock rock(slit_in_rock());
  const double modulus = 32e9 * (1 - 0.2) / ((1 + 0.2) * (1 - 2 * 0.2));
  bend(rock, modulus);
  Probes probes(rock.model.run_case.output.probes);
  const double expected = pull * std::pow(2.1 / length, 2);
  const ProbeValues seen = probes.observe(rock.model, rock.geometry, rock.state).front();
  // Elements of up to 1 m tell means: sigma'' h^2 / 12 = 10 kPa, while the stress changes by 260 kPa across
  // one.
  CHECK(seen.stress.yy + 5e6 == Approx(expected).margin(0.01e6));
  CHECK(seen.displacement[1] ==
        Approx(pull / modulus * std::pow(2.1, 3) / (3 * length * length)).epsilon(0.05));
  CHECK_FALSE(seen.joint.has_value());
}

TEST_CASE("a probe beside a fracture looks at its own side, and at the nearest joint",
          "[verification][structure]") {
  GrowingRock rock(slit_in_rock());
  const double strain = 1e-4;
  for (const auto& corners : rock.geometry.mesh.elements) {
    double middle = 0;
    for (const NodeIndex node : corners) middle += rock.geometry.mesh.position[node][1];
    if (middle <= 0) continue;
    for (const NodeIndex node : corners)
      if (const Point& at = rock.geometry.mesh.position[node]; std::abs(at[0]) < 2.4)
        rock.state.body.displacement[2 * std::size_t{node}] = strain * at[0];
  }
  Probes probes(rock.model.run_case.output.probes);
  const auto seen = probes.observe(rock.model, rock.geometry, rock.state);
  const double change = strain * 32e9 * (1 - 0.2) / ((1 + 0.2) * (1 - 2 * 0.2));
  CHECK(seen[1].stress.xx == Approx(-3e6 + change).epsilon(1e-4));
  CHECK(seen[2].stress.xx == Approx(-3e6).epsilon(1e-4));
  REQUIRE(seen[1].joint.has_value());
  CHECK(std::abs(rock.geometry.mesh.vertices[rock.geometry.mesh.units[*seen[1].joint].vertex].position[0] -
                 0.1) < 0.15);
}

TEST_CASE("only the rock of the rectangle moves at time 0", "[verification][structure]") {
  Case given = slit_in_rock();
  given.initial_velocities = {{{2, -1}, -8, 8, 0, 8}};
  GrowingRock rock(given);
  start_motion(rock.model, rock.geometry, rock.state);
  const Mesh& mesh = rock.geometry.mesh;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element)
    for (const NodeIndex node : mesh.elements[element]) {
      const double y = mesh.position[node][1], v = rock.state.body.velocity[2 * std::size_t{node}];
      if (y > 1) CHECK(v == 2);
      if (y < -1e-9) CHECK(v == 0);
    }
}
