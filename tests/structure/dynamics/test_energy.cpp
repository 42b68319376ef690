// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "structure/dynamics/central_difference.hpp"
#include "structure/dynamics/element_fields.hpp"
#include "structure/dynamics/energy.hpp"
#include "structure/dynamics/stable_step.hpp"
#include "tests/fakes/structure/jittered_mesh.hpp"
#include "tests/fakes/structure/shale_case.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

struct Block {
  Mesh mesh = jittered_mesh({8, 6, 32, 24, 0.2, 2});
  Elasticity moduli;
  Body body;
  Tiles tiles;

  explicit Block(const Case& settings)
      : moduli(elasticity(settings.rock)),
        body(build_body(mesh, settings)),
        tiles(build_tiles(mesh, body, {})) {}

  [[nodiscard]] std::vector<double> wave(double speed) const {
    std::vector<double> velocity;
    for (const Point& p : mesh.position) {
      velocity.push_back(speed * std::sin(0.7 * p[0]) * std::cos(0.3 * p[1]));
      velocity.push_back(speed * std::sin(0.5 * p[1]));
    }
    return velocity;
  }

  // Kinetic energy at the step itself: the mean of the half steps around it.
  [[nodiscard]] double energy_after(const std::vector<double>& displacement,
                                    const std::vector<double>& before,
                                    const std::vector<double>& after) const {
    std::vector<double> mean(before.size());
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5 * (before[i] + after[i]);
    return kinetic_energy(body, mean, 1) + strain_energy(mesh, moduli, displacement) +
           in_situ_work(mesh, body, displacement) - external_work(body, displacement);
  }
};

BulkFailure linear_softening() {
  BulkFailure settings;
  settings.active = true;
  settings.softening = Softening::linear;
  return settings;
}

}  // namespace

TEST_CASE("energy: a block moving as a whole and a block stretched evenly", "[structure][dynamics]") {
  const Block block(shale_case());
  std::vector<double> velocity, displacement;
  for (const Point& p : block.mesh.position) {
    velocity.insert(velocity.end(), {3, 4});
    displacement.insert(displacement.end(), {1e-4 * p[0], 0});
  }
  CHECK(kinetic_energy(block.body, velocity, 2) == Approx(2 * 0.5 * 2500 * 48 * 25).epsilon(1e-12));
  const double axial = block.moduli.lame + 2 * block.moduli.shear;
  CHECK(strain_energy(block.mesh, block.moduli, displacement) ==
        Approx(0.5 * axial * 1e-8 * 48).epsilon(1e-11));
}

TEST_CASE("energy: an undamped wave in stressed rock keeps its energy", "[structure][dynamics]") {
  const Block block(stressed_shale_case());
  State state = state_at_rest(block.body);
  state.velocity = block.wave(0.1);
  CentralDifference dynamics(block.body, block.tiles, block.moduli, 1);
  const auto stiffest = stiffest_element(block.mesh, block.moduli, 2500);
  const Step step{stable_step(stiffest.frequency_squared, 0, {0.5, 1, 0}), 0, 1, 0};
  const double start = kinetic_energy(block.body, state.velocity, 1);
  double least = HUGE_VAL, greatest = 0, least_kinetic = HUGE_VAL;
  for (int i = 0; i < 600; ++i) {
    const auto displacement = state.displacement, before = state.velocity;
    dynamics.advance(state, step);
    const double energy = block.energy_after(displacement, before, state.velocity);
    least = std::min(least, energy);
    greatest = std::max(greatest, energy);
    least_kinetic = std::min(least_kinetic, kinetic_energy(block.body, state.velocity, 1));
  }
  CHECK(least_kinetic < 0.8 * start);            // energy did change its form
  CHECK(least == Approx(start).epsilon(0.005));  // second order in the step: omega dt of the wave is small
  CHECK(greatest == Approx(start).epsilon(0.005));
}

TEST_CASE("energy: cracking takes from the wave what the fracture energy book says",
          "[structure][dynamics]") {
  Case settings = shale_case();
  settings.rock.poissons_ratio = 0;  // the book counts uniaxial cracking, and only then is all of it uniaxial
  settings.rock.fracture_energy = 500;
  settings.boundary.south.kind = settings.boundary.north.kind = BoundaryKind::roller;
  const Block block(settings);
  const RockFailure law = rock_failure(settings.rock, linear_softening());
  State state = state_at_rest(block.body, block.tiles);
  for (std::size_t node = 0; node < block.mesh.position.size(); ++node)
    state.velocity[2 * node] = 0.25 * std::sin(0.7 * block.mesh.position[node][0]);
  CentralDifference dynamics(block.body, block.tiles, block.moduli, law, 1);
  const auto stiffest = stiffest_element(block.mesh, block.moduli, 2500);
  const Step step{stable_step(stiffest.frequency_squared, 0, {0.1, 1, 0}), 0, 1, 0};
  const double start = kinetic_energy(block.body, state.velocity, 1);
  double dissipated = 0, energy = 0;
  for (int i = 0; i < 1500; ++i) {
    const auto displacement = state.displacement, before = state.velocity;
    dynamics.advance(state, step);
    const auto records = damage_records(block.tiles, state.damage);
    dissipated = failure_dissipation(block.mesh, law, records);
    energy = block.energy_after(displacement, before, state.velocity) -
             released_energy(block.mesh, block.body, block.moduli, displacement, records);
  }
  CAPTURE(start, energy, dissipated);
  CHECK(dissipated > 0.05 * start);
  CHECK(energy + dissipated == Approx(start).epsilon(0.01));  // the irregular mesh tilts some of the cracks
}

TEST_CASE("element fields: even strain on top of the in-situ stress", "[structure][dynamics]") {
  const Block block(stressed_shale_case());
  std::vector<double> displacement;
  for (const Point& p : block.mesh.position)
    displacement.insert(displacement.end(), {1e-4 * p[0] + 2e-5 * p[1], 3e-5 * p[0] - 4e-5 * p[1]});
  const ElementIndex cracked = 11;
  const auto stress =
      effective_stress(block.mesh, block.body, block.moduli, displacement, {{cracked, {1, 1, 1, 1}, {}}});
  const double single_precision = 2;  // [Pa], rounding of the stored in-situ stress
  CHECK(stress[3].in_plane.xx == Approx(-12.065876e6 + 3.2e6).margin(single_precision));
  CHECK(stress[3].in_plane.yy == Approx(-12.934124e6 - 1.6e6 / 3).margin(single_precision));
  CHECK(stress[3].in_plane.xy == Approx(-2.462019e6 + 2e6 / 3).margin(single_precision));
  CHECK(stress[3].out_of_plane == Approx(-20e6 + 1.6e6 / 3).margin(single_precision));
  const auto axes = principal_stresses(stress);
  CHECK(axes[3].major + axes[3].minor ==
        Approx(stress[3].in_plane.xx + stress[3].in_plane.yy).epsilon(1e-12));
  CHECK(stress[cracked].in_plane.xx ==
        Approx(stress[3].in_plane.xx).margin(single_precision));  // all in compression
  CHECK(damage_field(block.mesh, {{cracked, {1, 0.5, 1, 1}, {}}})[cracked] == 0.5);
}
