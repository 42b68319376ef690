// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "structure/material/failure_trigger.hpp"

using namespace fissura::structure;

namespace {

constexpr double cohesion = 10e6, friction_angle = 0.5235987755982988;
const MohrCoulombLimit mohr_coulomb({cohesion, std::sin(friction_angle), std::cos(friction_angle)});

double mohr_coulomb_value(const InPlane<double>& stress, double out_of_plane) {
  const auto in_plane = principal(stress);
  const auto [minor, major] = std::minmax({in_plane.major, in_plane.minor, out_of_plane});
  return (major - minor) + (major + minor) * std::sin(friction_angle) -
         2 * cohesion * std::cos(friction_angle);
}

}  // namespace

TEST_CASE("Rankine: fails where the major principal stress exceeds the strength", "[structure][material]") {
  const RankineSurface surface{1e6};
  const auto fails = [&](const InPlane<double>& stress) {
    return bool(exceeds(mohr_radius_squared(stress), surface.radius_limit(mohr_centre(stress))));
  };
  CHECK_FALSE(fails({0.999e6, -40e6, 0}));
  CHECK(fails({1.001e6, -40e6, 0}));
  CHECK_FALSE(fails({0, 0, 0.999e6}));
  CHECK(fails({0, 0, 1.001e6}));
  CHECK(fails({5e6, 5e6, 0}));  // inside out: a circle without radius beyond the limit
  CHECK_FALSE(fails({-5e6, -5e6, 0}));
}

TEST_CASE("Mohr-Coulomb: triaxial strength rises three times the confinement at 30 degrees",
          "[structure][material]") {
  const double unconfined = 34.641016e6, confinement = GENERATE(0.0, 10e6);
  const double strength = unconfined + 3 * confinement;
  const auto fails = [&](double axial) {
    const InPlane<double> stress{-axial, -confinement, 0};
    return bool(
        exceeds(mohr_radius_squared(stress), mohr_coulomb.radius_limit(mohr_centre(stress), -confinement)));
  };
  CHECK_FALSE(fails(strength * (1 - 1e-7)));  // digits of the source
  CHECK(fails(strength * (1 + 1e-7)));
}

TEST_CASE("Mohr-Coulomb: the limit on the radius is the criterion of the three principal stresses",
          "[structure][material]") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> megapascals(-60e6, 15e6);
  int failed = 0;
  for (int i = 0; i < 20000; ++i) {
    const InPlane<double> stress{megapascals(random), megapascals(random), 0.3 * megapascals(random)};
    const double out_of_plane = megapascals(random);
    const bool expected = mohr_coulomb_value(stress, out_of_plane) > 0;
    const double limit = mohr_coulomb.radius_limit(mohr_centre(stress), out_of_plane);
    REQUIRE(bool(exceeds(mohr_radius_squared(stress), limit)) == expected);
    failed += expected;
  }
  CHECK(failed > 1000);
  CHECK(failed < 19000);
}
