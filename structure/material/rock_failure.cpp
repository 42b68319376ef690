// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/material/rock_failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/errors.hpp"
#include "structure/material/crack_band.hpp"

namespace fissura::structure {

namespace {

RankineDamage tension_of(const Rock& rock, const BulkFailure& settings) {
  const Elasticity moduli = elasticity(rock);
  RankineDamage law{moduli.lame + 2 * moduli.shear, rock.tensile_strength, rock.fracture_energy,
                    settings.softening, std::nullopt};
  if (settings.strength_across_bedding)
    law.bedding = Bedding{*settings.strength_across_bedding,
                          {-std::sin(settings.bedding_angle), std::cos(settings.bedding_angle)}};
  return law;
}

// Major and minor in the plane and out of it, in descending order, with where each of them stands.
struct Sorted {
  std::array<double, 3> stress{};
  std::array<int, 3> place{};  ///< of the major, the minor and the out-of-plane stress
};

Sorted sorted(const Principal& axes, double out_of_plane) {
  if (out_of_plane > axes.major) return {{out_of_plane, axes.major, axes.minor}, {1, 2, 0}};
  if (out_of_plane > axes.minor) return {{axes.major, out_of_plane, axes.minor}, {0, 2, 1}};
  return {{axes.major, axes.minor, out_of_plane}, {0, 1, 2}};
}

// Tensor with these principal values along and across a direction; `shear_factor` is 1 for a stress, 2 for a
// strain with gamma_xy.
InPlane<double> turned(double along, double across, const std::array<double, 2>& direction,
                       double shear_factor) {
  const auto [x, y] = direction;
  return {along * x * x + across * y * y, along * y * y + across * x * x,
          shear_factor * (along - across) * x * y};
}

void shear(const RockFailure& law, PlaneStrainStress& stress, DamageHistory& damage,
           PlasticHistory& plastic) {
  const Principal axes = principal(stress.in_plane);
  const Sorted predictor = sorted(axes, stress.out_of_plane);
  std::array<double, 3> transmitted;
  for (int i = 0; i < 3; ++i) transmitted[i] = predictor.stress[i] > 0 ? 1 - damage.damage : 1;
  const PlasticReturn result = return_to_surface(*law.shear, predictor.stress, transmitted);
  if (result.place == ReturnedTo::inside) return;

  const auto [major, minor, out] = predictor.place;
  const InPlane<double> increment = turned(result.strain[major], result.strain[minor], axes.direction, 2);
  plastic.strain.xx += increment.xx;
  plastic.strain.yy += increment.yy;
  plastic.strain.xy += increment.xy;
  plastic.strain_zz += result.strain[out];
  for (int i = 0; i < 3; ++i) plastic.work += transmitted[i] * result.stress[i] * result.strain[i];
  stress.in_plane = turned(result.stress[major], result.stress[minor], axes.direction, 1);
  stress.out_of_plane = result.stress[out];

  const double extension = std::max(result.strain[major], result.strain[minor]);
  if (extension <= 0) return;
  const double before = dissipated_energy(law.tension, damage);
  grow_damage(law.tension, damage.equivalent_strain + extension, damage);
  plastic.worn += dissipated_energy(law.tension, damage) - before;
}

}  // namespace

RockFailure rock_failure(const Rock& rock, const BulkFailure& settings) {
  RockFailure law{tension_of(rock, settings), std::nullopt};
  if (settings.cohesion == 0) return law;
  const double sine = std::sin(settings.friction_angle), cosine = std::cos(settings.friction_angle);
  law.shear =
      MohrCoulomb{elasticity(rock), {settings.cohesion, sine, cosine}, std::sin(settings.dilation_angle)};
  const double strongest = std::max(rock.tensile_strength, settings.strength_across_bedding.value_or(0));
  const double sheared = 2 * settings.cohesion * cosine / (1 + sine);
  if (strongest > sheared)
    throw InputError(
        fmt::format("bulk_failure.cohesion: rock of this cohesion and friction shears in tension at {} Pa, "
                    "before it cracks at {} Pa; expected a greater cohesion",
                    sheared, strongest));
  return law;
}

double size_of(const PlasticHistory& plastic) {
  const auto& [xx, yy, xy] = plastic.strain;
  return std::sqrt((xx * xx + yy * yy + plastic.strain_zz * plastic.strain_zz + 0.5 * xy * xy) * 2 / 3);
}

PlaneStrainStress without_plastic_part(const Elasticity& moduli, const PlaneStrainStress& elastic,
                                       const PlasticHistory& plastic) {
  const double mean = moduli.lame * (plastic.strain.xx + plastic.strain.yy + plastic.strain_zz);
  const double twice = 2 * moduli.shear;
  return {{elastic.in_plane.xx - (mean + twice * plastic.strain.xx),
           elastic.in_plane.yy - (mean + twice * plastic.strain.yy),
           elastic.in_plane.xy - moduli.shear * plastic.strain.xy},
          elastic.out_of_plane - (mean + twice * plastic.strain_zz)};
}

PlaneStrainStress transmitted_stress(const PlaneStrainStress& undamaged, double damage) {
  const auto& in_plane = undamaged.in_plane;
  const auto tensile = tensile_part(in_plane);
  return {{in_plane.xx - damage * tensile.xx, in_plane.yy - damage * tensile.yy,
           in_plane.xy - damage * tensile.xy},
          undamaged.out_of_plane - damage * std::max(undamaged.out_of_plane, 0.0)};
}

std::optional<DamageHistory> failure_onset(const RockFailure& law, const PlaneStrainStress& elastic,
                                           const std::array<std::array<double, 2>, 3>& corner) {
  const Principal axes = principal(elastic.in_plane);
  const DamageHistory history =
      undamaged_band(law.tension, axes.direction, crack_band_length(corner, axes.direction));
  const bool cracks = axes.major > history.tensile_strength;
  const bool shears =
      law.shear && yield_value(law.shear->surface, sorted(axes, elastic.out_of_plane).stress) > 0;
  if (!cracks && !shears) return std::nullopt;
  return history;
}

PlaneStrainStress failed_stress(const RockFailure& law, const PlaneStrainStress& elastic,
                                DamageHistory& damage, PlasticHistory& plastic) {
  PlaneStrainStress stress = elastic;
  if (law.shear) {
    stress = without_plastic_part(law.shear->moduli, elastic, plastic);
    shear(law, stress, damage, plastic);
  }
  grow_damage(law.tension, principal(stress.in_plane).major / law.tension.band_modulus, damage);
  return transmitted_stress(stress, damage.damage);
}

double dissipated_energy(const RockFailure& law, const DamageHistory& damage, const PlasticHistory& plastic) {
  return dissipated_energy(law.tension, damage) - plastic.worn + plastic.work;
}

}  // namespace fissura::structure
