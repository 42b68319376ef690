// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "structure/joints/joint_step.hpp"

using namespace fissura;
using namespace fissura::structure;

namespace {

constexpr double mass = 100, arm = 0.5, step = 1e-4;  // arm: length of a face
const JointStepControls undamped{step, 1, 0, 1};

/// Wedges of rock, one node each, that meet at one point; wedge k lies between arms k and k + 1 of the
/// junction.
struct Junction {
  Mesh mesh;
  Joints joints;
  std::vector<NodeIndex> nodes;
  std::vector<double> masses, displacement, velocity;

  /// @param angles  of the arms, ascending, counter-clockwise from x [rad]
  Junction(const std::vector<double>& angles, const JointProperties& properties) {
    const auto count = static_cast<NodeIndex>(angles.size());
    mesh.position.resize(count);
    FractureVertex vertex;
    for (NodeIndex k = 0; k < count; ++k) {
      ContactUnit unit;
      unit.minus = (k + count - 1) % count;
      unit.plus = k;
      unit.face = {-arm * std::sin(angles[k]), arm * std::cos(angles[k])};
      unit.length = arm;
      mesh.units.push_back(unit);
      vertex.units.push_back(k);
      nodes.push_back(k);
    }
    mesh.vertices = {vertex};
    joints.properties.assign(count, properties);
    joints.state.resize(count);
    joints.released.assign(count, 1);
    joints.ramp.resize(count);
    masses.assign(count, mass);
    displacement.assign(2 * count, 0);
    velocity.assign(2 * count, 0);
  }

  void advance(const std::vector<double>& force, const JointStepControls& controls) {
    JointStep(mesh, nodes, 1).advance({force, nodes, masses, displacement, velocity}, controls, joints);
  }

  void press(double pressure) {
    for (PressureRamp& ramp : joints.ramp) ramp = {pressure, pressure, 0, 0, 0};
  }

  [[nodiscard]] Point velocity_of(std::size_t wedge) const {
    return {velocity[2 * wedge], velocity[2 * wedge + 1]};
  }
};

const std::vector<double> thirds{0, 2 * std::numbers::pi / 3, 4 * std::numbers::pi / 3};
/// A T: rock below, and above to the right and to the left.
const std::vector<double> tee{0, std::numbers::pi / 2, std::numbers::pi};
enum Wedge : std::size_t { right = 0, left = 1, below = 2 };

Point turned(Point v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v[0] - s * v[1], s * v[0] + c * v[1]};
}

/// Pushes each of three like wedges towards the middle with a traction on its two faces [Pa].
std::vector<double> squeeze(double traction) {
  std::vector<double> force;
  const double size = traction * arm * std::numbers::sqrt3;  // two faces at 60 degrees to the wedge's axis
  for (const double angle : thirds) {
    const Point inward = turned({-size, 0}, angle + std::numbers::pi / 3);
    force.insert(force.end(), {inward[0], inward[1]});
  }
  return force;
}

JointProperties frictional(double coefficient) {
  JointProperties properties;
  properties.friction_coefficient = coefficient;
  properties.kind = FractureKind::natural;
  return properties;
}

JointProperties cohesive_rock() {
  JointProperties properties;
  properties.cohesive = {1e6, 50};
  properties.kind = FractureKind::intact;
  return properties;
}

}  // namespace

TEST_CASE("fluid opens a symmetric junction symmetrically, once it exceeds the closure",
          "[structure][joints]") {
  Junction junction(thirds, JointProperties{});
  const double closure = 5e6;
  junction.press(0.98 * closure);
  for (int k = 0; k < 20; ++k) junction.advance(squeeze(closure), undamped);
  for (const JointState& state : junction.joints.state) CHECK(std::abs(state.opening) < 1e-12);

  junction.press(1.1 * closure);
  for (int k = 0; k < 20; ++k) junction.advance(squeeze(closure), undamped);
  for (std::size_t k = 0; k < 3; ++k) {
    const JointState& state = junction.joints.state[k];
    CHECK_FALSE(state.closed);
    CHECK(state.opening > 1e-6);
    CHECK(state.opening == Approx(junction.joints.state[0].opening).epsilon(1e-9));
    CHECK(std::abs(state.sliding) < 1e-9 * state.opening);
    const Point expected = turned(junction.velocity_of(0), thirds[k]);
    CHECK(junction.velocity_of(k)[0] == Approx(expected[0]).margin(1e-9));
    CHECK(junction.velocity_of(k)[1] == Approx(expected[1]).margin(1e-9));
  }
  // Newton's second law of a wedge under the excess of pressure.
  const double acceleration = 0.1 * closure * arm * std::numbers::sqrt3 / mass;
  CHECK(std::hypot(junction.velocity_of(0)[0], junction.velocity_of(0)[1]) ==
        Approx(20 * step * acceleration).epsilon(1e-6));
}

TEST_CASE("cohesion holds a junction closed by its strength", "[structure][joints]") {
  Junction junction(thirds, cohesive_rock());
  const double closure = 5e6;
  junction.press(closure + 0.95e6);
  for (int k = 0; k < 20; ++k) junction.advance(squeeze(closure), undamped);
  for (const JointState& state : junction.joints.state) CHECK(state.opening < 1e-9);
  junction.press(closure + 1.1e6);
  for (int k = 0; k < 20; ++k) junction.advance(squeeze(closure), undamped);
  for (const JointState& state : junction.joints.state) CHECK(state.opening > 1e-8);
}

TEST_CASE("a junction that is pulled apart takes the fracture energy of its faces from the motion",
          "[structure][joints]") {
  constexpr double heavy = 1e9, speed = 1e-2;
  Junction junction(thirds, cohesive_rock());
  junction.masses.assign(3, heavy);
  for (std::size_t wedge = 0; wedge < 3; ++wedge) {
    const Point away = turned({speed, 0}, thirds[wedge] + std::numbers::pi / 3);
    junction.velocity[2 * wedge] = away[0];
    junction.velocity[2 * wedge + 1] = away[1];
  }
  junction.advance(squeeze(-1.1e6), undamped);
  const auto momentum = [&] { return heavy * std::hypot(junction.velocity[0], junction.velocity[1]); };
  const double before = momentum();
  while (junction.joints.state[0].opening < 1.2e-4) junction.advance(squeeze(0), undamped);
  // Three wedges at `speed` work against three faces; the first step spent one of 70 parts before.
  CHECK((before - momentum()) * speed / arm == Approx(50).epsilon(0.03));
  for (UnitIndex unit = 0; unit < 3; ++unit) CHECK(junction.joints.broken(unit));
}

TEST_CASE("wedges that are apart move freely", "[structure][joints]") {
  Junction junction(thirds, frictional(0.8));
  junction.press(1e6);
  for (int k = 0; k < 20; ++k) junction.advance(squeeze(0), undamped);
  junction.press(0);
  junction.velocity[0] += 0.4;
  junction.velocity[1] -= 0.7;
  junction.velocity[4] -= 0.2;
  const std::vector<double> before = junction.velocity;
  for (int k = 0; k < 5; ++k) junction.advance(squeeze(0), undamped);
  for (const JointState& state : junction.joints.state) REQUIRE(state.opening > 1e-6);
  for (std::size_t dof = 0; dof < 6; ++dof) CHECK(junction.velocity[dof] == before[dof]);
}

TEST_CASE("nothing inside a junction changes its momentum", "[structure][joints]") {
  std::mt19937_64 random(3);
  const auto number = [&](double size) {
    return size * (2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1);
  };
  Junction junction(GENERATE(thirds, tee), cohesive_rock());
  Point impulse{};
  for (int k = 0; k < 200; ++k) {
    std::vector<double> force = squeeze(5e5);
    for (std::size_t dof = 0; dof < 6; ++dof) {
      force[dof] += number(1e6);
      impulse[dof % 2] += step * force[dof];
    }
    junction.press(number(4e6));
    junction.advance(force, undamped);
    Point momentum{};
    for (std::size_t dof = 0; dof < 6; ++dof) momentum[dof % 2] += mass * junction.velocity[dof];
    REQUIRE(std::abs(momentum[0] - impulse[0]) < 1e-9);  // of impulses of the order of 100 N s
    REQUIRE(std::abs(momentum[1] - impulse[1]) < 1e-9);
  }
}

TEST_CASE("a junction under compression moves as one piece of rock", "[structure][joints]") {
  Junction junction(GENERATE(thirds, tee), frictional(0.8));
  std::vector<double> force = squeeze(5e6);
  force[2] += 3e5;
  force[3] -= 1e5;
  for (int k = 0; k < 100; ++k) junction.advance(force, undamped);
  Point sum{};
  for (std::size_t dof = 0; dof < 6; ++dof) sum[dof % 2] += force[dof];
  for (std::size_t wedge = 0; wedge < 3; ++wedge)
    for (std::size_t axis = 0; axis < 2; ++axis)
      CHECK(junction.velocity_of(wedge)[axis] ==
            Approx(100 * step * sum[axis] / (3 * mass)).margin(1e-3 * 100 * step * 3e5 / mass));
  for (const JointState& state : junction.joints.state) {
    CHECK(state.closed);
    CHECK(state.held_normal < 0);
  }
}

TEST_CASE("rock at a junction that has not been released stays whole whatever pulls at it",
          "[structure][joints]") {
  Junction junction(thirds, cohesive_rock());
  junction.joints.released.assign(3, 0);
  for (int k = 0; k < 50; ++k) junction.advance(squeeze(-3e7), undamped);
  // Nothing is out of balance: what moves is what the sweeps have left over.
  for (const double displacement : junction.displacement) CHECK(std::abs(displacement) < 1e-7);
  // A force handed round the junction is in balance everywhere; only the mean of the tractions is certain.
  double mean = 0;
  for (const JointState& state : junction.joints.state) mean += state.held_normal / 3;
  CHECK(mean == Approx(3e7).epsilon(1e-4));
}

TEST_CASE("the faces of a junction do not overlap, however it is struck", "[structure][joints]") {
  std::mt19937_64 random(5);
  Junction junction(GENERATE(thirds, tee), frictional(0.3));
  double deepest = 0, fastest = 0;
  for (int k = 0; k < 400; ++k) {
    for (double& velocity : junction.velocity) {
      if (k % 40 == 0) velocity += 2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1;
      fastest = std::max(fastest, std::abs(velocity));
    }
    junction.advance(squeeze(1e6), undamped);
    for (const JointState& state : junction.joints.state) deepest = std::min(deepest, state.opening);
  }
  CHECK(fastest > 0.5);
  // Of what the faces would have gone into one another in a single step.
  CHECK(deepest > -1e-2 * fastest * step);
}

TEST_CASE("Coulomb friction at a junction sticks below and slides above mu times the normal traction",
          "[structure][joints]") {
  constexpr double coefficient = 0.6, normal = 10e6, limit = coefficient * normal;
  // The rock above is pressed onto that below and sheared along it as a whole.
  const auto load = [&](double shear) {
    std::vector<double> force(6, 0);
    for (const Wedge wedge : {right, left}) {
      force[2 * wedge] = shear * arm;
      force[2 * wedge + 1] = -normal * arm;
    }
    force[2 * below] = -2 * shear * arm;
    force[2 * below + 1] = 2 * normal * arm;
    return force;
  };
  Junction sticking(tee, frictional(coefficient));
  sticking.masses[below] = 2 * mass;
  for (int k = 0; k < 50; ++k) sticking.advance(load(0.95 * limit), undamped);
  for (const JointState& state : sticking.joints.state) CHECK(std::abs(state.sliding) < 1e-9);

  Junction sliding(tee, frictional(coefficient));
  sliding.masses[below] = 2 * mass;
  constexpr int steps = 50;
  for (int k = 0; k < steps; ++k) sliding.advance(load(1.5 * limit), undamped);
  // The excess accelerates the upper blocks to one side and the lower one to the other.
  const double relative = 2 * 0.5 * limit * arm / mass * steps * step;
  for (const Wedge wedge : {right, left}) {
    CHECK(sliding.velocity_of(wedge)[0] - sliding.velocity_of(below)[0] == Approx(relative).epsilon(1e-3));
    CHECK(std::abs(sliding.velocity_of(wedge)[1] - sliding.velocity_of(below)[1]) < 1e-6 * relative);
  }
}

TEST_CASE("damping at a junction acts on what is out of balance, not on the contact forces",
          "[structure][joints]") {
  Junction junction(thirds, frictional(0.8));
  for (std::size_t wedge = 0; wedge < 3; ++wedge) junction.velocity[2 * wedge + 1] = 1e-3;
  JointStepControls damped = undamped;
  damped.damping = 0.5;
  for (int k = 0; k < 20; ++k) junction.advance(squeeze(1e7), damped);
  // In balance nothing is damped, however large the forces on each wedge.
  for (std::size_t wedge = 0; wedge < 3; ++wedge)
    CHECK(junction.velocity_of(wedge)[1] == Approx(1e-3).epsilon(1e-3));
}
