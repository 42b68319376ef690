// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "structure/dynamics/energy.hpp"
#include "structure/structure_run.hpp"
#include "tests/structure/fracture/growing_rock.hpp"

/// An elastic body in equilibrium does not notice that patches of it are meshed anew. A slit is under
/// pressure; the segments inserted at its tips stay welded, so that the body is the same one all the time.

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

constexpr double pressure = 1e6;
constexpr double half_length = 2.5;
constexpr int first_steps = 6000, further_steps = 1500;

struct PressurisedSlit {
  GrowingRock rock{slit()};

  PressurisedSlit() {
    for (PressureRamp& ramp : rock.state.joints.ramp) ramp = {pressure, pressure, 0, 0, 0};
    relax(first_steps);
  }

  static Case slit() {
    Case given = free_slit();
    given.dynamics.damping = 0.5;
    given.growth.trigger = -1e9;  // every tip advances
    return given;
  }

  void relax(int steps) {
    StructureRun run(rock.model, rock.geometry);
    run.advance(0, 0.999 * steps * stable_step(rock.model, rock.geometry, rock.state), rock.state);
  }

  /// @returns segments inserted
  std::size_t remesh() {
    const std::size_t units = rock.state.joints.released.size();
    const std::size_t segments = rock.insert(rock.plan()).size();
    for (std::size_t unit = units; unit < rock.state.joints.released.size(); ++unit)
      rock.state.joints.released[unit] = 0;
    return segments;
  }

  [[nodiscard]] double energy() const {
    return strain_energy(rock.geometry.mesh, rock.model.moduli, rock.state.body.displacement);
  }
  [[nodiscard]] double aperture() const {
    const VertexIndex middle = nearest_split_vertex(rock.geometry.mesh, {0, 0});
    return rock.state.joints.state[rock.geometry.mesh.vertices[middle].units[0]].opening;
  }
  [[nodiscard]] double mass() const {
    return std::accumulate(rock.geometry.body.mass.begin(), rock.geometry.body.mass.end(), 0.0);
  }
};

}  // namespace

TEST_CASE("remesh invariance: energy within 1 %, aperture within 0.5 % over twenty patches, mass exact",
          "[verification][structure]") {
  PressurisedSlit slit;
  const double energy = slit.energy(), aperture = slit.aperture(), mass = slit.mass();
  // Sneddon: w(0) = 4 p a / E' in a boundless body; the free sides, 2.2 half-lengths beyond the tips, add
  // some of it.
  const double sneddon = 4 * pressure * half_length / slit.rock.model.run_case.rock.plane_strain_modulus();
  REQUIRE(aperture > sneddon);
  REQUIRE(aperture < 1.3 * sneddon);
  std::size_t patches = 0;
  double at_once = 0;
  while (patches < 20) {
    const double before = slit.energy();
    patches += slit.remesh();
    at_once = std::max(at_once, std::abs(slit.energy() - before) / energy);
    slit.relax(further_steps);
  }
  CAPTURE(patches, slit.energy() / energy - 1, slit.aperture() / aperture - 1, at_once,
          slit.mass() / mass - 1);
  CHECK(std::abs(slit.energy() / energy - 1) < 0.01);
  CHECK(std::abs(slit.aperture() / aperture - 1) < 0.005);
  CHECK(std::abs(slit.mass() / mass - 1) < 1e-14);
  CHECK(at_once < 0.01);  // before anything has come to rest again
  for (const FractureVertex& vertex : slit.rock.geometry.mesh.vertices)
    CHECK(std::abs(vertex.position[1]) < 0.6 * slit.rock.h());  // straight on, as symmetry asks for
}
