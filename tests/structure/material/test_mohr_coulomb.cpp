// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "structure/material/mohr_coulomb.hpp"

using namespace fissura::structure;

namespace {

constexpr double degree = 0.017453292519943295, cohesion = 10e6;
constexpr std::array<double, 3> whole{1, 1, 1};
const Elasticity moduli = elasticity(32e9, 0.2);

MohrCoulomb law_of(double friction, double dilation) {
  return {moduli,
          {cohesion, std::sin(friction * degree), std::cos(friction * degree)},
          std::sin(dilation * degree)};
}

std::array<double, 3> elastic_stress_of(const std::array<double, 3>& strain) {
  const double mean = moduli.lame * (strain[0] + strain[1] + strain[2]);
  return {mean + 2 * moduli.shear * strain[0], mean + 2 * moduli.shear * strain[1],
          mean + 2 * moduli.shear * strain[2]};
}

}  // namespace

TEST_CASE("Mohr-Coulomb: return to the plane", "[structure][material]") {
  const auto law = law_of(30, 10);
  const std::array<double, 3> predictor{-5e6, -30e6, -80e6};
  CHECK(yield_value(law.surface, predictor) == Approx(15.179492e6).epsilon(1e-7));
  const auto result = return_to_surface(law, predictor, whole);
  const double digits = 0.06;  // [Pa], half of the last digit of the reference
  CHECK(result.place == ReturnedTo::plane);
  CHECK(result.stress[0] == Approx(-13.5491951e6).margin(digits));
  CHECK(result.stress[1] == Approx(-30.7675593e6).margin(digits));
  CHECK(result.stress[2] == Approx(-75.2886014e6).margin(digits));
  CHECK(result.strain[0] == Approx(2.4863613e-4 * (1 + law.sine_dilation)).epsilon(1e-7));
  CHECK(result.strain[1] == 0);
}

TEST_CASE("Mohr-Coulomb: the triaxial strength is that of the closed form", "[structure][material]") {
  const auto law = law_of(30, 10);
  const double confinement = GENERATE(0.0, 10e6);
  std::array<double, 3> strain{}, plastic{};
  double axial = 0;
  for (int step = 1; step <= 400; ++step) {
    strain[2] = -1e-5 * step;
    std::array<double, 3> predictor{};
    // Lateral strains that keep the confinement; two rounds of a relaxation that overshoots nothing.
    for (int round = 0; round < 60; ++round) {
      const std::array<double, 3> elastic{strain[0] - plastic[0], strain[1] - plastic[1],
                                          strain[2] - plastic[2]};
      predictor = elastic_stress_of(elastic);
      const auto result = return_to_surface(law, predictor, whole);
      for (int i = 0; i < 2; ++i) strain[i] -= 0.5 * (result.stress[i] + confinement) / (2 * moduli.shear);
    }
    const auto result = return_to_surface(law, predictor, whole);
    for (int i = 0; i < 3; ++i) plastic[i] += result.strain[i];
    axial = -result.stress[2];
  }
  CHECK(axial == Approx(34.641016e6 + 3 * confinement).epsilon(1e-6));
}

TEST_CASE("Mohr-Coulomb: the shear plane stands at 45 degrees and half the friction angle",
          "[structure][material]") {
  const auto law = law_of(30, 10);
  const auto stress = return_to_surface(law, {-10e6, -20e6, -90e6}, whole).stress;
  const double tangent = law.surface.sine_friction / law.surface.cosine_friction;
  double greatest = -HUGE_VAL, angle = 0;
  for (double degrees = 0; degrees < 90; degrees += 0.01) {
    const double cosine = std::cos(2 * degrees * degree), sine = std::sin(2 * degrees * degree);
    const double normal = 0.5 * (stress[0] + stress[2]) + 0.5 * (stress[2] - stress[0]) * cosine;
    const double excess = 0.5 * (stress[0] - stress[2]) * sine + normal * tangent - cohesion;
    if (excess > greatest) {
      greatest = excess;
      angle = degrees;
    }
  }
  CHECK(angle == Approx(60).margin(0.02));               // between the greatest compression and the normal
  CHECK(greatest == Approx(0).margin(1e-6 * cohesion));  // step of the search
}

TEST_CASE("Mohr-Coulomb: beyond the apex the stress is even", "[structure][material]") {
  const auto law = law_of(30, 10);
  const auto result = return_to_surface(law, {60e6, 55e6, 50e6}, whole);
  CHECK(result.place == ReturnedTo::apex);
  for (const double stress : result.stress) CHECK(stress == Approx(17.32050808e6).epsilon(1e-9));
}

TEST_CASE("Mohr-Coulomb: every return ends on the surface, in order, by the strain it reports",
          "[structure][material]") {
  const auto law = GENERATE(law_of(30, 10), law_of(30, 30), law_of(45, 0), law_of(20, 5), law_of(0, 0));
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> pascals(-120e6, 40e6);
  std::array<int, 5> ended{};
  for (int i = 0; i < 20000; ++i) {
    std::array<double, 3> predictor{pascals(random), pascals(random), pascals(random)};
    std::sort(predictor.rbegin(), predictor.rend());
    const auto result = return_to_surface(law, predictor, whole);
    ++ended[static_cast<std::size_t>(result.place)];
    const double rounding = 1e-4;  // [Pa] of stresses of 1e8 Pa
    if (result.place == ReturnedTo::inside) {
      REQUIRE(yield_value(law.surface, predictor) <= 0);
      continue;
    }
    const auto relaxed = elastic_stress_of(result.strain);
    REQUIRE(std::abs(yield_value(law.surface, result.stress)) < rounding);
    REQUIRE(result.stress[0] >= result.stress[1] - rounding);
    REQUIRE(result.stress[1] >= result.stress[2] - rounding);
    double work = 0;
    for (int k = 0; k < 3; ++k) {
      REQUIRE(predictor[k] - relaxed[k] == Approx(result.stress[k]).margin(rounding));
      work += result.stress[k] * result.strain[k];
    }
    REQUIRE(work >= -rounding);
    if (result.place == ReturnedTo::apex) continue;
    const double volume = result.strain[0] + result.strain[1] + result.strain[2];
    const double shear = result.strain[0] - result.strain[2];
    REQUIRE(shear > 0);
    // Each flow vector dilates by 2 sin(psi) for 2 of strain between its two directions.
    if (result.place == ReturnedTo::plane) REQUIRE(volume == Approx(shear * law.sine_dilation).margin(1e-15));
  }
  CHECK(ended[static_cast<std::size_t>(ReturnedTo::plane)] > 1000);
  CHECK(ended[static_cast<std::size_t>(ReturnedTo::right_edge)] > 100);
  CHECK(ended[static_cast<std::size_t>(ReturnedTo::left_edge)] > 100);
}

TEST_CASE("Mohr-Coulomb: the surface bounds the stress a crack transmits", "[structure][material]") {
  const auto law = law_of(30, 10);
  const double cracked = 0.1;
  const std::array<double, 3> transmitted{cracked, 1, 1};
  CHECK(return_to_surface(law, {25e6, -10e6, -20e6}, transmitted).place == ReturnedTo::inside);
  const auto result = return_to_surface(law, {25e6, -10e6, -60e6}, transmitted);
  CHECK(result.place == ReturnedTo::plane);
  CHECK(yield_value(law.surface, {cracked * result.stress[0], result.stress[1], result.stress[2]}) ==
        Approx(0).margin(1e-4));
}
