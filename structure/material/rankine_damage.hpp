// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "structure/material/mohr_circle.hpp"

/// Isotropic, unilateral Rankine damage of the effective stress, regularised by the fracture energy (the
/// crack band of Bazant & Oh 1983). With the undamaged effective stress s (in-situ part included) the stress
/// is
///   sigma = s - D s+ ,   s+ = tensile part of s ,
/// so that a closed crack carries compression at full stiffness, and D grows with
///   kappa = largest value so far of  <major principal s> / E .
/// D unloads along the secant. Softening starts at eps_0 = f_t / E and spends G_f over the band length l:
///   linear       D = eps_f (kappa - eps_0) / (kappa (eps_f - eps_0)),   eps_f = 2 G_f / (f_t l)
///   exponential  D = 1 - (eps_0 / kappa) exp(-(kappa - eps_0) / eps_e), eps_e = G_f / (f_t l) - eps_0 / 2
/// In an element too wide to release G_f stably the strength is lowered, not the energy.
namespace fissura::structure {

using fissura::Softening;

struct RankineDamage {
  double youngs_modulus = 0;    ///< E [Pa]
  double tensile_strength = 0;  ///< f_t [Pa]
  double fracture_energy = 0;   ///< G_f [J/m2]
  Softening softening = Softening::linear;
};

/// What a cracked element remembers. Band length and strength are frozen at onset.
struct DamageHistory {
  double equivalent_strain = 0;  ///< kappa, largest so far [-]
  double damage = 0;             ///< D, 0 to 1 [-]
  double band_length = 0;        ///< l [m]
  double tensile_strength = 0;   ///< of this element, at most f_t [Pa]
};

/// min(f_t, sqrt(2 E G_f / l)) [Pa] for a band of length l [m].
double admissible_strength(const RankineDamage& law, double band_length);

/// D at the equivalent strain kappa [-] of an element of this strength [Pa] and band length [m]; 0 up to
/// onset.
double damage_of_strain(const RankineDamage& law, double strength, double band_length,
                        double equivalent_strain);

/// Energy spent per volume in uniaxial tension up to kappa,  integral of E k^2 / 2 dD(k)  [J/m3]; G_f / l at
/// the end.
double dissipated_energy(const RankineDamage& law, const DamageHistory& history);

/// History of an element at the onset of damage, or nothing while its undamaged stress [Pa] is below its
/// strength.
std::optional<DamageHistory> damage_onset(const RankineDamage& law, const InPlane<double>& undamaged_stress,
                                          double band_length);

/// Lets the damage grow to the equivalent strain  major principal s / E  [-] if it is the largest so far.
void grow_damage(const RankineDamage& law, double equivalent_strain, DamageHistory& history);

/// Lets the damage grow to the undamaged stress [Pa] and returns the stress  s - D s+  [Pa].
InPlane<double> damaged_stress(const RankineDamage& law, const InPlane<double>& undamaged_stress,
                               DamageHistory& history);

}  // namespace fissura::structure
