// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "common/errors.hpp"
#include "structure/material/rock_failure.hpp"

using namespace fissura;
using namespace fissura::structure;

namespace {

constexpr double degree = 0.017453292519943295;
constexpr std::array<std::array<double, 2>, 3> corner{{{0, 0}, {0.2, 0}, {0, 0.2}}};

Rock shale() {
  Rock rock;
  rock.density = 2500;
  rock.youngs_modulus = 32e9;
  rock.poissons_ratio = 0.2;
  rock.tensile_strength = 1e6;
  rock.fracture_energy = 50;
  return rock;
}

BulkFailure cohesive() {
  BulkFailure settings;
  settings.active = true;
  settings.softening = Softening::linear;
  settings.cohesion = 10e6;
  settings.friction_angle = 30 * degree;
  settings.dilation_angle = 10 * degree;
  return settings;
}

// An element under in-situ stress that is strained step by step.
struct Element {
  RockFailure law = rock_failure(shale(), cohesive());
  Elasticity moduli = elasticity(shale());
  PlaneStrainStress in_situ;
  std::optional<DamageHistory> damage = std::nullopt;
  PlasticHistory plastic{};

  PlaneStrainStress strain_to(const InPlane<double>& strain) {
    const auto change = elastic_stress(moduli, strain);
    const PlaneStrainStress elastic{
        {in_situ.in_plane.xx + change.xx, in_situ.in_plane.yy + change.yy, in_situ.in_plane.xy + change.xy},
        in_situ.out_of_plane + out_of_plane_stress(moduli, strain)};
    if (!damage) damage = failure_onset(law, elastic, corner);
    return damage ? failed_stress(law, elastic, *damage, plastic) : elastic;
  }
};

double yield_of(const RockFailure& law, const PlaneStrainStress& stress) {
  const auto axes = principal(stress.in_plane);
  std::array<double, 3> values{axes.major, axes.minor, stress.out_of_plane};
  std::sort(values.rbegin(), values.rend());
  return yield_value(law.shear->surface, values);
}

}  // namespace

TEST_CASE("rock: tension cracks at the tensile strength, far from Mohr-Coulomb", "[structure][material]") {
  Element element{.in_situ = {}};
  double peak = 0;
  for (int step = 1; step <= 4000; ++step)
    peak = std::max(peak, element.strain_to({1e-7 * step, 0, 0}).in_plane.xx);
  CHECK(peak == Approx(1e6).epsilon(1e-3));  // one step of strain
  CHECK(element.plastic.work == 0);
  CHECK(size_of(element.plastic) == 0);
}

TEST_CASE("rock: the opening of a band whose rock beside holds its strain spends the fracture energy",
          "[structure][material]") {
  const PlaneStrainStress in_situ =
      GENERATE(PlaneStrainStress{}, PlaneStrainStress{{-10e6, -15e6, 0}, -20e6});
  Element element{.in_situ = in_situ};
  const double start = in_situ.in_plane.xx < 0 ? 10e6 / element.law.tension.band_modulus : 0;
  double work = 0, before = 0;
  constexpr double increment = 1e-8;
  for (int step = 1; step <= 80000; ++step) {
    const double now = element.strain_to({start + increment * step, 0, 0}).in_plane.xx;
    work += 0.5 * (before + now) * increment;
    before = now;
  }
  CHECK(before == 0);
  CHECK(work * element.damage->band_length == Approx(50).epsilon(1e-3));  // one step at the corner of the law
  CHECK(dissipated_energy(element.law, *element.damage, element.plastic) * element.damage->band_length ==
        Approx(50).epsilon(1e-9));
}

TEST_CASE("rock: confined compression flows at Mohr-Coulomb and dilates", "[structure][material]") {
  Element element{.in_situ = {{-20e6, -20e6, 0}, -20e6}};
  PlaneStrainStress stress;
  double work = 0;
  PlaneStrainStress before = element.in_situ;
  for (int step = 1; step <= 4000; ++step) {
    const double size = 1e-6;
    stress = element.strain_to({0.2 * size * step, -size * step, 0});
    work += 0.5 *
            ((before.in_plane.xx + stress.in_plane.xx) * 0.2 - (before.in_plane.yy + stress.in_plane.yy)) *
            size;
    before = stress;
  }
  CHECK(yield_of(element.law, stress) == Approx(0).margin(1));  // [Pa]
  const auto& strain = element.plastic.strain;
  CHECK(strain.xx > 0);
  CHECK(strain.yy < 0);
  CHECK(strain.xx + strain.yy + element.plastic.strain_zz > 0);
  // What does not go into elastic energy is plastic work.
  const InPlane<double> elastic{0.2 * 4e-3 - strain.xx, -4e-3 - strain.yy, 0};
  const double zz = -element.plastic.strain_zz;
  const double volume = elastic.xx + elastic.yy + zz;
  const double stored = 0.5 * element.moduli.lame * volume * volume +
                        element.moduli.shear * (elastic.xx * elastic.xx + elastic.yy * elastic.yy + zz * zz) -
                        20e6 * volume;
  CHECK(work - stored == Approx(element.plastic.work).epsilon(1e-3));  // steps of the plastic work
}

TEST_CASE("rock: dilatant shear wears the tensile strength down without spending the fracture energy",
          "[structure][material]") {
  Element element{.in_situ = {{-1e6, -1e6, 0}, -1e6}};
  for (int step = 1; step <= 3000; ++step) element.strain_to({1e-7 * step, -1e-6 * step, 0});
  REQUIRE(element.damage.has_value());
  const auto& damage = *element.damage;
  CHECK(damage.damage > 0.1);
  const double left = 1 - lost_strength(element.law.tension, damage);
  CHECK(left < 0.9);
  CHECK(dissipated_energy(element.law.tension, damage) - element.plastic.worn <
        0.05 * dissipated_energy(element.law.tension, damage));

  const InPlane<double> unloaded = element.plastic.strain;
  element.strain_to(unloaded);
  const double sheared = size_of(element.plastic);
  REQUIRE(1 - lost_strength(element.law.tension, damage) == left);
  double peak = 0;
  for (int step = 1; step <= 4000; ++step)
    peak = std::max(peak, element.strain_to({unloaded.xx + 1e-7 * step, unloaded.yy, 0}).in_plane.xx);
  CHECK(size_of(element.plastic) == sheared);
  CHECK(peak == Approx(left * damage.tensile_strength).epsilon(0.02));  // one step of strain
}

TEST_CASE("rock: sheared rock unloads along its elastic stiffness and a crack in it closes in full",
          "[structure][material]") {
  Element element{.in_situ = {{-20e6, -20e6, 0}, -20e6}};
  const auto loaded = element.strain_to({2e-4, -4e-3, 0});
  const auto plastic = element.plastic.strain;
  const auto unloaded = element.strain_to({2e-4, -3.9e-3, 0});
  const double axial = element.moduli.lame + 2 * element.moduli.shear;
  CHECK(unloaded.in_plane.yy - loaded.in_plane.yy == Approx(axial * 1e-4).epsilon(1e-9));
  CHECK(element.plastic.strain.yy == plastic.yy);

  element.damage->damage = 1;
  const auto closed = element.strain_to({1e-4, -3.9e-3, 0});
  CHECK(closed.in_plane.xx < 0);
  CHECK(unloaded.in_plane.xx - closed.in_plane.xx == Approx(axial * 1e-4).epsilon(1e-9));
}

TEST_CASE("rock: the out-of-plane stress takes part in shear", "[structure][material]") {
  Element element{.in_situ = {{-30e6, -20e6, 0}, 0}};
  const auto stress = element.strain_to({-1e-3, 0, 0});
  REQUIRE(element.damage.has_value());
  CHECK(element.plastic.strain_zz > 0);
  CHECK(yield_of(element.law, stress) == Approx(0).margin(1));
}

TEST_CASE("laminated rock: strength by the direction of the crack", "[structure][material]") {
  BulkFailure settings = cohesive();
  settings.strength_across_bedding = 0.4e6;
  settings.bedding_angle = 30 * degree;
  const auto law = rock_failure(shale(), settings).tension;
  const auto strength_at = [&](double degrees) {
    return strength_of_direction(law, {std::cos(degrees * degree), std::sin(degrees * degree)});
  };
  CHECK(strength_at(30) == Approx(1e6).epsilon(1e-12));
  CHECK(strength_at(120) == Approx(0.4e6).epsilon(1e-12));
  CHECK(strength_at(75) == Approx(0.7e6).epsilon(1e-12));
  CHECK(lowest_strength(law, 0.1) == Approx(0.4e6));
  // Pulled along x, 60 degrees off the bedding normal.
  const double expected = 1e6 - 0.6e6 * 0.25;
  CHECK_FALSE(damage_onset(law, {0.999 * expected, 0, 0}, 0.1).has_value());
  const auto history = damage_onset(law, {1.001 * expected, 0, 0}, 0.1);
  REQUIRE(history.has_value());
  CHECK(history->tensile_strength == Approx(expected).epsilon(1e-12));
}

TEST_CASE("rock: a cohesion too low for tension to crack is refused", "[structure][material]") {
  BulkFailure settings = cohesive();
  settings.cohesion = 0.8e6;
  CHECK_THROWS_AS(rock_failure(shale(), settings), InputError);
  settings.cohesion = 0.9e6;
  CHECK_NOTHROW(rock_failure(shale(), settings));
}

TEST_CASE("lost strength and equivalent strain are inverse to each other", "[structure][material]") {
  BulkFailure settings = cohesive();
  settings.softening = GENERATE(Softening::linear, Softening::exponential);
  const auto law = rock_failure(shale(), settings).tension;
  for (const double band : {0.1, 0.5, 10.0}) {
    DamageHistory history = undamaged_band(law, {1, 0}, band);
    for (const double share : {0.0, 0.3, 0.9, 0.999}) {
      const double strain = strain_of_lost_strength(law, history.tensile_strength, band, share);
      history = undamaged_band(law, {1, 0}, band);
      grow_damage(law, strain, history);
      if (band < 5) CHECK(lost_strength(law, history) == Approx(share).margin(1e-9));
    }
  }
}
