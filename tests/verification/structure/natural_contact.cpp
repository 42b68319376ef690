// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "common/errors.hpp"
#include "structure/initial_motion.hpp"
#include "structure/joints/face_pair.hpp"
#include "structure/structure_run.hpp"
#include "tests/structure/fracture/growing_rock.hpp"

/// Contact of natural fractures in rock: at rest, coming to rest, sheared.

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

/// A cross and a T of natural fractures in compression, with the same friction; tau / sigma_n is 0.16 at
/// most.
Case network_with(double friction) {
  Case given = free_case(12);
  given.mesh.far_size = 0.5;
  given.in_situ.stress = {-10e6, -12e6, 1e6, -10e6};
  add_line(given, "level", FractureKind::natural, {-3, 0}, {3, 0});
  add_line(given, "steep", FractureKind::natural, {-1, -2}, {1, 2});
  add_line(given, "arriving", FractureKind::natural, {2, 2.5}, {2, 0});
  for (FractureLine& line : given.fractures) line.friction_coefficient = friction;
  return given;
}

/// A square of 4 m cut in two at half its height; the upper side is moved by 4 mm under 10 MPa, which takes
/// 0.1 s.
Case shear_box() {
  Case given = free_case(4);
  given.mesh.fracture_size = given.mesh.natural_size = given.mesh.tip_size = 0.4;
  given.mesh.far_size = 0.5;
  given.in_situ.stress = {0, -10e6, 0, 0};
  given.boundary.south = {BoundaryKind::fixed, {}, 0};
  given.boundary.north = {BoundaryKind::displacement, {4e-3, 0}, 0.1};
  given.dynamics.initial_mass_scale = 1;
  add_line(given, "cut", FractureKind::natural, {-2, 0}, {2, 0});
  return given;
}

/// Mean over a fracture of the traction its faces transmit [Pa].
ContactTraction mean_traction(const GrowingRock& rock) {
  ContactTraction sum;
  double length = 0;
  for (UnitIndex unit = 0; unit < rock.geometry.mesh.units.size(); ++unit) {
    const ContactTraction here =
        contact_traction(rock.state.joints.properties[unit], rock.state.joints.state[unit], true);
    const double l = rock.geometry.mesh.units[unit].length;
    sum.normal += l * here.normal;
    sum.shear += l * here.shear;
    length += l;
  }
  return {sum.normal / length, sum.shear / length};
}

double greatest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

void run_steps(GrowingRock& rock, int steps) {
  const double step = 0.99 * stable_step(rock.model, rock.geometry, rock.state);
  StructureRun(rock.model, rock.geometry).advance(0, steps * step, rock.state);
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace

TEST_CASE("a network that holds rests: 5000 steps move nothing", "[verification][structure]") {
  GrowingRock rock(network_with(0.6));
  const Equilibration rest = come_to_rest(rock.model, rock.geometry, rock.state);
  CHECK(rest.steps <= 10);
  CHECK(rest.greatest_slip < 1e-12);
  run_steps(rock, 5000);
  CHECK(greatest(rock.state.body.displacement) < 1e-9);
  for (const JointState& state : rock.state.joints.state) CHECK(state.closed);
}

TEST_CASE("a network that does not hold slides until it rests, and slip counts from there",
          "[verification][structure]") {
  constexpr double friction = 0.05;
  GrowingRock rock(network_with(friction));
  const Equilibration rest = come_to_rest(rock.model, rock.geometry, rock.state);
  CHECK(rest.greatest_slip > 1e-5);
  CHECK_FALSE(rest.fracture.empty());
  for (const JointState& state : rock.state.joints.state) {
    CHECK(state.sliding == 0);
    CHECK(state.slip == 0);
    CHECK(state.opening > -1e-9);
  }
  CHECK(greatest(rock.state.body.velocity) == 0);
  run_steps(rock, 1000);
  for (const JointState& state : rock.state.joints.state) {
    CHECK(std::abs(state.sliding) < 1e-7);
    // Coulomb's law holds at crossing and T as between them; the impulses at junctions settle to 1e-6.
    if (state.closed)
      CHECK(std::abs(state.held_tangential) <= friction * std::abs(state.held_normal) * (1 + 1e-3));
  }
}

TEST_CASE("coming to rest leaves cement that holds as it was", "[verification][structure]") {
  Case given = network_with(0.05);
  given.fractures[0].tensile_strength = 5e6;
  given.fractures[0].fracture_energy = 500;
  GrowingRock rock(given);
  CHECK(come_to_rest(rock.model, rock.geometry, rock.state).greatest_slip > 1e-6);
  for (UnitIndex unit = 0; unit < rock.geometry.mesh.units.size(); ++unit)
    if (rock.state.joints.properties[unit].cohesive.strength > 0) {
      CHECK(rock.state.joints.state[unit].greatest_separation == 0);
      CHECK_FALSE(rock.state.joints.broken(unit));
    }
}

TEST_CASE("a fracture that never comes to rest is named", "[verification][structure][fault]") {
  Case given = shear_box();
  given.boundary.north = {BoundaryKind::traction, {0, 0}, 0};
  given.in_situ.stress = {0, -10e6, 2e6, 0};
  given.fractures[0].friction_coefficient = 0.1;
  GrowingRock rock(given);
  CHECK_THROWS_WITH(come_to_rest(rock.model, rock.geometry, rock.state),
                    Catch::Contains("natural fracture 'cut' does not come to rest under the in-situ stress"));
}

TEST_CASE("shear box: a cut under 10 MPa slides at mu times the normal stress", "[verification][structure]") {
  GrowingRock rock(shear_box());
  StructureRun run(rock.model, rock.geometry);
  double peak = 0;
  for (int k = 0; k < 50; ++k) {
    run.advance(0.002 * k, 0.002 * (k + 1), rock.state);
    peak = std::max(peak, std::abs(mean_traction(rock).shear));
  }
  // The ends, where shear cannot enter from the free sides, slide first and lie open to bending: 1 %.
  CHECK(peak == Approx(6.0e6).epsilon(0.01));
  CHECK(mean_traction(rock).normal == Approx(-10e6).epsilon(0.01));
  for (const JointState& state : rock.state.joints.state) CHECK(std::abs(state.sliding) > 5e-4);
}

TEST_CASE("shear box: dilation presses the rock apart without a burst", "[verification][structure]") {
  Case given = shear_box();
  given.fractures[0].dilation_angle = std::atan(0.1);
  given.fractures[0].dilation_slip = 1e-3;
  GrowingRock rock(given);
  StructureRun run(rock.model, rock.geometry);
  // The opening is one step behind a slip of 4 mm in 0.1 s at most.
  const double one_step = 0.1 * 0.04 * stable_step(rock.model, rock.geometry, rock.state) + contact_tolerance;
  double kinetic = 0;
  for (int k = 0; k < 50; ++k) {
    run.advance(0.002 * k, 0.002 * (k + 1), rock.state);
    kinetic = std::max(kinetic, run.kinetic_energy());
  }
  for (const JointState& state : rock.state.joints.state) {
    const double due = 0.1 * std::min(state.slip, 1e-3);
    CHECK(state.closed);
    CHECK(state.opening == Approx(due).margin(one_step));
  }
  // Held above and below, the cut's 0.1 mm press sigma_n up by E' 0.1 mm / 4 m = 0.8 MPa (less at the free
  // sides).
  const double normal = mean_traction(rock).normal;
  CHECK(normal < -10.4e6);
  CHECK(normal > -10.9e6);
  // The upper half moves at 4 mm / 0.1 s: 2500 * 8 m2 / 2 * (0.04 m/s)^2 = 16 J/m; a burst would stand out.
  CHECK(kinetic < 3 * 16);
}

TEST_CASE("joints on two threads move as on one, bit for bit", "[verification][structure]") {
  Case given = free_case(24);
  given.mesh.far_size = 0.5;
  given.in_situ.stress = {-10e6, -12e6, 1e6, -10e6};
  for (int k = 0; k < 8; ++k) {
    const double at = -10.5 + 3 * k;
    add_line(given, "level " + std::to_string(k), FractureKind::natural, {-11, at}, {11, at});
    add_line(given, "steep " + std::to_string(k), FractureKind::natural, {at, -11}, {at, 11});
  }
  for (FractureLine& line : given.fractures) {
    line.friction_coefficient = 0.05;
    line.dilation_angle = 0.02;
    line.dilation_slip = 1e-3;
  }
  GrowingRock one(given), two(given);
  two.model.threads = 2;
  REQUIRE(one.geometry.mesh.units.size() > 1100);
  run_steps(one, 60);
  run_steps(two, 60);
  CHECK(same_bits(one.state.body.displacement, two.state.body.displacement));
  CHECK(same_bits(one.state.body.velocity, two.state.body.velocity));
  double slip = 0;
  for (std::size_t unit = 0; unit < one.state.joints.state.size(); ++unit) {
    CHECK(one.state.joints.state[unit].slip == two.state.joints.state[unit].slip);
    slip = std::max(slip, one.state.joints.state[unit].slip);
  }
  CHECK(slip > 1e-5);
}
