// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "structure/material/crack_band.hpp"
#include "structure/material/rankine_damage.hpp"

using namespace fissura::structure;

namespace {

constexpr double modulus = 32e9, strength = 1e6, fracture_energy = 50;
constexpr double onset_strain = strength / modulus;
constexpr RankineDamage linear{modulus, strength, fracture_energy, Softening::linear};
constexpr RankineDamage exponential{modulus, strength, fracture_energy, Softening::exponential};

double uniaxial_stress(const RankineDamage& law, DamageHistory& history, double strain) {
  return damaged_stress(law, {modulus * strain, 0, 0}, history).xx;
}

}  // namespace

TEST_CASE("softening: damage at multiples of the onset strain for four band lengths",
          "[structure][material]") {
  struct Row {
    double band, linear_twice, exponential_twice, exponential_tenfold;
  };
  const auto row = GENERATE(Row{0.10, 0.516129, 0.531240, 0.944046}, Row{0.25, 0.542373, 0.577953, 0.978247},
                            Row{0.50, 0.592593, 0.654761, 0.996433}, Row{1.00, 0.727273, 0.798555, 0.999972});
  const double digits = 6e-7;  // half of the last digit printed
  CHECK(damage_of_strain(linear, strength, row.band, 2 * onset_strain) ==
        Approx(row.linear_twice).margin(digits));
  CHECK(damage_of_strain(exponential, strength, row.band, 2 * onset_strain) ==
        Approx(row.exponential_twice).margin(digits));
  CHECK(damage_of_strain(exponential, strength, row.band, 10 * onset_strain) ==
        Approx(row.exponential_tenfold).margin(digits));
  CHECK(damage_of_strain(linear, strength, row.band, onset_strain) == 0);
  CHECK(damage_of_strain(linear, strength, row.band, 2 * fracture_energy / (strength * row.band)) == 1);
}

TEST_CASE("softening: stretching a band apart spends the fracture energy", "[structure][material]") {
  const auto law = GENERATE(linear, exponential);
  const auto band = GENERATE(0.05, 0.1, 0.2, 0.25, 1.0);
  auto history = *damage_onset(law, {strength * (1 + 1e-12), 0, 0}, band);
  const double end = 60 * fracture_energy / (strength * band);
  constexpr int steps = 2'000'000;
  double work = 0.5 * strength * onset_strain, before = strength;
  const double increment = (end - onset_strain) / steps;
  for (int i = 1; i <= steps; ++i) {
    const double now = uniaxial_stress(law, history, onset_strain + i * increment);
    work += 0.5 * (before + now) * increment;
    before = now;
  }
  CHECK(work * band ==
        Approx(fracture_energy).epsilon(1e-4));  // trapezoids across the corner at onset and end
  CHECK(dissipated_energy(law, history) * band == Approx(fracture_energy).epsilon(1e-9));
}

TEST_CASE("softening: the dissipated energy is the integral of the energy release rate",
          "[structure][material]") {
  const auto law = GENERATE(linear, exponential);
  const double band = 0.5;
  auto history = *damage_onset(law, {strength * (1 + 1e-12), 0, 0}, band);
  double integral = 0, damage = 0;
  constexpr int steps = 20000;
  for (int i = 1; i <= steps; ++i) {
    const double middle = onset_strain * (1 + 3 * (i - 0.5) / steps);
    uniaxial_stress(law, history, onset_strain * (1 + 3.0 * i / steps));
    integral += 0.5 * modulus * middle * middle * (history.damage - damage);
    damage = history.damage;
  }
  CHECK(damage > 0.5);
  CHECK(dissipated_energy(law, history) == Approx(integral).epsilon(1e-6));  // midpoint rule
}

TEST_CASE("softening: an element too wide loses strength, not fracture energy", "[structure][material]") {
  const double limit = 2 * modulus * fracture_energy / (strength * strength);
  CHECK(admissible_strength(linear, strength, 0.9 * limit) == strength);
  const double band = 4 * limit;
  CHECK(admissible_strength(linear, strength, band) == Approx(0.5 * strength).epsilon(1e-12));
  for (const auto& law : {linear, exponential}) {
    auto history = *damage_onset(law, {strength, 0, 0}, band);
    CHECK(uniaxial_stress(law, history, onset_strain) == Approx(0).margin(1e-3));  // [Pa]: brittle at once
    CHECK(history.damage == Approx(1).epsilon(1e-9));
    CHECK(dissipated_energy(law, history) * band == Approx(fracture_energy).epsilon(1e-9));
  }
}

TEST_CASE("damage: a cracked element closes at full stiffness and unloads along the secant",
          "[structure][material]") {
  auto history = *damage_onset(linear, {2 * strength, 0, 0}, 0.5);
  const double loaded = uniaxial_stress(linear, history, 3 * onset_strain);
  CHECK(history.damage > 0.7);
  CHECK(uniaxial_stress(linear, history, 1.5 * onset_strain) == Approx(0.5 * loaded).epsilon(1e-12));
  CHECK(uniaxial_stress(linear, history, -2 * onset_strain) == Approx(-2 * strength).epsilon(1e-12));
  CHECK(uniaxial_stress(linear, history, 3 * onset_strain) == Approx(loaded).epsilon(1e-12));
}

TEST_CASE("damage: compression along the crack is carried in full", "[structure][material]") {
  auto history = *damage_onset(linear, {2 * strength, -20 * strength, 0}, 0.5);
  const auto stress = damaged_stress(linear, {2 * strength, -20 * strength, 0}, history);
  CHECK(stress.xx == Approx((1 - history.damage) * 2 * strength).epsilon(1e-9));
  CHECK(stress.yy == Approx(-20 * strength).epsilon(1e-12));
  CHECK(stress.xy == Approx(0).margin(1e-6));
}

TEST_CASE("damage starts at the tensile strength", "[structure][material]") {
  CHECK_FALSE(damage_onset(linear, {0.999 * strength, -50e6, 0}, 0.25).has_value());
  CHECK(damage_onset(linear, {1.001 * strength, -50e6, 0}, 0.25).has_value());
}

TEST_CASE("crack band: the height over an edge parallel to the crack", "[structure][material]") {
  const double h = 0.4, height = h * std::sqrt(3.0) / 2;
  const std::array<std::array<double, 2>, 3> half_square{{{0, 0}, {h, 0}, {0, h}}};
  const std::array<std::array<double, 2>, 3> equilateral{{{0, 0}, {h, 0}, {0.5 * h, height}}};
  CHECK(crack_band_length(half_square, {0, 1}) == Approx(h).epsilon(1e-12));
  CHECK(crack_band_length(half_square, {-1, 0}) == Approx(h).epsilon(1e-12));
  CHECK(crack_band_length(equilateral, {0, 1}) == Approx(height).epsilon(1e-12));
  CHECK(crack_band_length(equilateral, {1, 0}) == Approx(h).epsilon(1e-12));
}
