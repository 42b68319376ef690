// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "structure/joints/face_pair.hpp"
#include "tests/structure/joints/block_pair.hpp"

using namespace fissura;
using namespace fissura::structure;
using fakes::BlockPair;

namespace {

constexpr double mass = 100, length = 0.5, step = 1e-4;
const JointStepControls undamped{step, 1, 0, 1};

JointProperties cohesive_rock() {
  JointProperties properties;
  properties.cohesive = {1e6, 50};
  properties.kind = FractureKind::intact;
  return properties;
}

JointProperties frictional(double coefficient) {
  JointProperties properties;
  properties.friction_coefficient = coefficient;
  properties.kind = FractureKind::natural;
  return properties;
}

/// Forces that press two faces together with a traction [Pa], and shear them with another.
struct Squeeze {
  double normal = 0, shear = 0;
  void apply(BlockPair& pair, const JointStepControls& controls) const {
    pair.step({shear * length, normal * length}, {-shear * length, -normal * length}, controls);
  }
};

}  // namespace

TEST_CASE("touching faces move together and transmit the traction between them", "[structure][joints]") {
  BlockPair pair(JointProperties{}, mass, length);
  for (int k = 0; k < 100; ++k) pair.step({0, 3e5}, {0, -1e5}, undamped);
  CHECK(pair.state().closed);
  CHECK(pair.velocity_minus()[1] == pair.velocity_plus()[1]);
  // Newton's second law of both together.
  CHECK(pair.velocity_plus()[1] == Approx(100 * step * 2e5 / (2 * mass)).epsilon(1e-12));
  CHECK(pair.state().held_normal == Approx(-2e5 / length).epsilon(1e-12));
  CHECK(std::abs(pair.state().opening) < 1e-15);
}

TEST_CASE("fluid pressure parts the faces when it exceeds closure and cohesion", "[structure][joints]") {
  BlockPair pair(cohesive_rock(), mass, length);
  const Squeeze closure{5e6, 0};
  pair.set_ramp({5.99e6, 5.99e6, 0, 0, 0});
  for (int k = 0; k < 20; ++k) closure.apply(pair, undamped);
  CHECK(pair.state().closed);
  CHECK(pair.state().opening == 0);
  pair.set_ramp({6.01e6, 6.01e6, 0, 0, 0});
  closure.apply(pair, undamped);
  CHECK_FALSE(pair.state().closed);
  CHECK(pair.state().opening > 0);
}

TEST_CASE("rock that has not been released stays whole whatever pulls at it", "[structure][joints]") {
  BlockPair pair(cohesive_rock(), mass, length);
  pair.hold_as_rock();
  for (int k = 0; k < 100; ++k) Squeeze{-1e8, 2e8}.apply(pair, undamped);
  CHECK(pair.velocity_minus() == pair.velocity_plus());
  CHECK(pair.state().held_normal == Approx(1e8).epsilon(1e-12));
}

TEST_CASE("faces that meet again do not overlap", "[structure][joints]") {
  BlockPair pair(JointProperties{}, mass, length);
  pair.step({0, 0}, {0, mass / step}, undamped);
  pair.set_velocity_plus({0, 0.2});
  for (int k = 0; k < 10; ++k) pair.step({0, 0}, {0, 0}, undamped);
  CHECK(pair.state().opening == Approx(step * (1 + 10 * 0.2)).epsilon(1e-12));
  pair.set_velocity_plus({0, -50});
  for (int k = 0; k < 10; ++k) {
    pair.step({0, 0}, {0, 0}, undamped);
    CHECK(pair.state().opening > -1e-12);
  }
  CHECK(pair.velocity_plus()[1] == Approx(pair.velocity_minus()[1]).margin(1e-9));
}

TEST_CASE("a stiff enclosed fluid does not bind the explicit step", "[structure][joints]") {
  // The limit of an explicit spring would be 2 / sqrt(k l 2 / m) = 6.3e-8 s here.
  BlockPair pair(JointProperties{}, mass, length);
  pair.set_velocity_plus({0, 0.1});
  pair.set_ramp({1e6, 1e6, 0, 1e-3, 1e17});
  double largest = 0;
  for (int k = 0; k < 1000; ++k) {
    pair.step({0, 1e6 * length}, {0, -1e6 * length}, undamped);
    largest = std::max(largest, std::abs(pair.velocity_plus()[1]));
    REQUIRE(std::isfinite(largest));
  }
  CHECK(pair.state().opening == Approx(1e-3).epsilon(1e-6));
}

TEST_CASE("Coulomb friction sticks below and slides above mu times the effective normal traction",
          "[structure][joints]") {
  constexpr double coefficient = 0.6, normal = 10e6, pore = 4e6, limit = coefficient * (normal - pore);
  BlockPair sticking(frictional(coefficient), mass, length);
  sticking.set_ramp({pore, pore, 0, 0, 0});
  for (int k = 0; k < 50; ++k) Squeeze{normal, 0.999 * limit}.apply(sticking, undamped);
  CHECK(sticking.state().slip < 1e-15);

  BlockPair sliding(frictional(coefficient), mass, length);
  sliding.set_ramp({pore, pore, 0, 0, 0});
  constexpr int steps = 50;
  for (int k = 0; k < steps; ++k) Squeeze{normal, 1.5 * limit}.apply(sliding, undamped);
  // The excess accelerates each block: relative acceleration 2 (tau - limit) l / m.
  const double acceleration = 2 * 0.5 * limit * length / mass;
  CHECK(sliding.velocity_minus()[0] - sliding.velocity_plus()[0] ==
        Approx(acceleration * steps * step).epsilon(1e-9));
  CHECK(sliding.state().closed);
}

TEST_CASE("a sliding block is stopped by friction where the energy says", "[structure][joints]") {
  // Both blocks are of mass m; the relative motion is that of m/2 against the friction, so v0^2 / (4 mu N / m).
  constexpr double coefficient = 0.5, normal = 2e3, speed = 2;
  BlockPair pair(frictional(coefficient), mass, length);
  pair.set_velocity_plus({speed, 0});
  const double deceleration = 2 * coefficient * normal * length / mass;
  for (int k = 0; k < 4500; ++k) Squeeze{normal, 0}.apply(pair, undamped);
  CHECK(pair.velocity_plus()[0] == Approx(pair.velocity_minus()[0]).margin(1e-12));
  CHECK(pair.state().slip == Approx(speed * speed / (2 * deceleration)).epsilon(1e-3));
}

TEST_CASE("faces that strike each other rub by mu times the blow", "[structure][joints]") {
  // Contact that flickers would otherwise carry a share of the load without friction.
  constexpr double coefficient = 0.5;
  BlockPair pair(frictional(coefficient), mass, length);
  pair.step({0, 0}, {0, mass / step}, undamped);
  REQUIRE_FALSE(pair.state().closed);
  const Point minus = pair.velocity_minus();
  pair.set_velocity_plus({minus[0] + 100, minus[1] - 50});
  double normal = -50, tangential = 100;
  for (int k = 0; k < 4; ++k) {
    pair.step({0, 0}, {0, 0}, undamped);
    const double normal_now = pair.velocity_plus()[1] - pair.velocity_minus()[1];
    const double tangential_now = pair.velocity_plus()[0] - pair.velocity_minus()[0];
    CHECK(tangential - tangential_now == Approx(coefficient * (normal_now - normal)).margin(1e-9));
    normal = normal_now;
    tangential = tangential_now;
  }
  CHECK(normal == Approx(0).margin(1e-9));
  CHECK(tangential == Approx(100 - coefficient * 50));
}

TEST_CASE("local damping of touching faces acts on what is out of balance, not on the contact force",
          "[structure][joints]") {
  BlockPair pair(JointProperties{}, mass, length);
  pair.set_velocity_plus({0, -1e-3});
  JointStepControls damped = undamped;
  damped.damping = 0.5;
  const Squeeze balanced{1e7, 0};
  balanced.apply(pair, damped);
  const double common = pair.velocity_plus()[1];
  for (int k = 0; k < 10; ++k) balanced.apply(pair, damped);
  // In balance nothing is damped, however large the forces on each side.
  CHECK(pair.velocity_plus()[1] == common);
}

TEST_CASE("a joint that is pulled apart takes its fracture energy from the motion", "[structure][joints]") {
  constexpr double heavy = 1e9, speed = 1e-2;
  BlockPair pair(cohesive_rock(), heavy, length);
  pair.set_velocity_plus({0, speed});
  // T_n is half the pull on one of two equal blocks: just above the strength, so that the faces part.
  pair.step({0, 0}, {0, 2.2e6 * length}, undamped);
  const double momentum = heavy * pair.velocity_plus()[1];
  while (pair.state().opening < 1.2e-4) pair.step({0, 0}, {0, 0}, undamped);
  const double impulse = momentum - heavy * pair.velocity_plus()[1];
  // Work per area = impulse x relative speed / length, less what the first step of 1 of 100 spent.
  CHECK(impulse * speed / length == Approx(50).epsilon(0.03));
  CHECK(pair.joints().broken(0));
}

TEST_CASE("at a kink, fluid pressure balances closure on the same face vector", "[structure][joints]") {
  // Two edges of 0.5 m that meet at 60 degrees to their chord: 0.5 m of trace, a face vector of 0.25 m.
  ContactUnit kink;
  kink.plus = 1;
  kink.face = {0, length / 2};
  kink.length = length;
  const std::vector<double> masses{mass, mass};
  const FacePair pair = face_pair(kink, masses, 1);
  CHECK(pair.length == Approx(length / 2));
  CHECK(pair.flatness == Approx(0.5));
  CHECK(dot(pair.normal, pair.normal) == Approx(1));
}
