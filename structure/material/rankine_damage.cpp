// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/material/rankine_damage.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::structure {

namespace {

double linear_final_strain(const RankineDamage& law, double strength, double band_length) {
  return 2 * law.fracture_energy / (strength * band_length);
}

double exponential_strain(const RankineDamage& law, double strength, double band_length) {
  return law.fracture_energy / (strength * band_length) - 0.5 * strength / law.band_modulus;
}

}  // namespace

double strength_of_direction(const RankineDamage& law, const std::array<double, 2>& normal) {
  if (!law.bedding) return law.tensile_strength;
  const auto& across = law.bedding->normal;
  const double cosine = normal[0] * across[0] + normal[1] * across[1];
  return law.tensile_strength + (law.bedding->strength_across - law.tensile_strength) * cosine * cosine;
}

double admissible_strength(const RankineDamage& law, double strength, double band_length) {
  return std::min(strength, std::sqrt(2 * law.band_modulus * law.fracture_energy / band_length));
}

double lowest_strength(const RankineDamage& law, double band_length) {
  const double weakest =
      law.bedding ? std::min(law.tensile_strength, law.bedding->strength_across) : law.tensile_strength;
  return admissible_strength(law, weakest, band_length);
}

double damage_of_strain(const RankineDamage& law, double strength, double band_length,
                        double equivalent_strain) {
  const double onset = strength / law.band_modulus;
  if (equivalent_strain <= onset) return 0;
  if (law.softening == Softening::linear) {
    const double final = linear_final_strain(law, strength, band_length);
    if (equivalent_strain >= final) return 1;
    return final * (equivalent_strain - onset) / (equivalent_strain * (final - onset));
  }
  const double decay = exponential_strain(law, strength, band_length);
  if (decay <= 0) return 1;
  return 1 - (onset / equivalent_strain) * std::exp(-(equivalent_strain - onset) / decay);
}

double lost_strength(const RankineDamage& law, const DamageHistory& history) {
  const double left =
      (1 - history.damage) * law.band_modulus * history.equivalent_strain / history.tensile_strength;
  return std::clamp(1 - left, 0.0, 1.0);
}

double strain_of_lost_strength(const RankineDamage& law, double strength, double band_length, double share) {
  constexpr double least_left = 1e-12;
  const double onset = strength / law.band_modulus;
  if (law.softening == Softening::linear)
    return onset + share * std::max(linear_final_strain(law, strength, band_length) - onset, 0.0);
  const double decay = std::max(exponential_strain(law, strength, band_length), 0.0);
  return onset - decay * std::log(std::max(1 - share, least_left));
}

double dissipated_energy(const RankineDamage& law, const DamageHistory& history) {
  const double onset = history.tensile_strength / law.band_modulus;
  if (history.equivalent_strain <= onset) return 0;
  const double scale = 0.5 * history.tensile_strength;
  if (law.softening == Softening::linear) {
    const double final = linear_final_strain(law, history.tensile_strength, history.band_length);
    if (final <= onset) return scale * onset;
    return scale * final * (std::min(history.equivalent_strain, final) - onset) / (final - onset);
  }
  const double decay = exponential_strain(law, history.tensile_strength, history.band_length);
  if (decay <= 0) return scale * onset;
  const double excess = (history.equivalent_strain - onset) / decay;
  return scale * ((decay + onset) * (1 - std::exp(-excess)) + decay * (1 - (1 + excess) * std::exp(-excess)));
}

DamageHistory undamaged_band(const RankineDamage& law, const std::array<double, 2>& normal,
                             double band_length) {
  const double strength = admissible_strength(law, strength_of_direction(law, normal), band_length);
  return {strength / law.band_modulus, 0, band_length, strength, normal};
}

std::optional<DamageHistory> damage_onset(const RankineDamage& law, const InPlane<double>& undamaged_stress,
                                          double band_length) {
  const Principal axes = principal(undamaged_stress);
  const DamageHistory history = undamaged_band(law, axes.direction, band_length);
  if (axes.major <= history.tensile_strength) return std::nullopt;
  return history;
}

void grow_damage(const RankineDamage& law, double equivalent_strain, DamageHistory& history) {
  if (equivalent_strain <= history.equivalent_strain) return;
  history.equivalent_strain = equivalent_strain;
  history.damage = damage_of_strain(law, history.tensile_strength, history.band_length, equivalent_strain);
}

InPlane<double> damaged_stress(const RankineDamage& law, const InPlane<double>& undamaged_stress,
                               DamageHistory& history) {
  const double centre = mohr_centre(undamaged_stress),
               radius = std::sqrt(mohr_radius_squared(undamaged_stress));
  grow_damage(law, (centre + radius) / law.band_modulus, history);
  const auto tensile = tensile_part(undamaged_stress, centre, radius);
  return {undamaged_stress.xx - history.damage * tensile.xx,
          undamaged_stress.yy - history.damage * tensile.yy,
          undamaged_stress.xy - history.damage * tensile.xy};
}

}  // namespace fissura::structure
