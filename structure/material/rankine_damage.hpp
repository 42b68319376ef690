// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "structure/material/mohr_circle.hpp"

/// Isotropic, unilateral Rankine damage of the effective stress, regularised by the fracture energy (the
/// crack band of Bazant & Oh 1983). With the undamaged effective stress s (in-situ part included) the stress
/// is
///   sigma = s - D s+ ,   s+ = tensile part of s ,
/// so that a closed crack carries compression at full stiffness, and D grows with
///   kappa = largest value so far of  <major principal s> / M .
/// D unloads along the secant. Softening starts at eps_0 = f_t / M and spends G_f over the band length l:
///   linear       D = eps_f (kappa - eps_0) / (kappa (eps_f - eps_0)),   eps_f = 2 G_f / (f_t l)
///   exponential  D = 1 - (eps_0 / kappa) exp(-(kappa - eps_0) / eps_e), eps_e = G_f / (f_t l) - eps_0 / 2
/// M is the stiffness of the element against a strain across the band while the rock beside holds its
/// strain along it: then kappa is that strain and the opening of the band spends exactly G_f. In plane strain
/// M = lambda + 2 G; Young's modulus would fall short of G_f by M / E - 1. In an element too wide to release
/// G_f stably the strength is lowered, not the energy.
namespace fissura::structure {

using fissura::Softening;

/// Planes of weakness of laminated rock.
struct Bedding {
  double strength_across = 0;          ///< f_t of a crack along the bedding, which opens across it [Pa]
  std::array<double, 2> normal{0, 1};  ///< unit vector
};

struct RankineDamage {
  double band_modulus = 0;      ///< M [Pa]
  double tensile_strength = 0;  ///< f_t; of laminated rock along its bedding [Pa]
  double fracture_energy = 0;   ///< G_f [J/m2]
  Softening softening = Softening::linear;
  std::optional<Bedding> bedding = std::nullopt;  ///< without it the rock is isotropic
};

/// What a cracked element remembers. All but the first two are frozen at onset.
struct DamageHistory {
  double equivalent_strain = 0;        ///< kappa, largest so far [-]
  double damage = 0;                   ///< D, 0 to 1 [-]
  double band_length = 0;              ///< l [m]
  double tensile_strength = 0;         ///< of this element, at most f_t [Pa]
  std::array<double, 2> normal{1, 0};  ///< of the crack, a unit vector of either sign
};

/// f_t = f_along + (f_across - f_along) (n . b)^2  [Pa] of a crack with the unit normal n in rock with the
/// bedding normal b; f_t of isotropic rock.
double strength_of_direction(const RankineDamage& law, const std::array<double, 2>& normal);

/// min(f, sqrt(2 M G_f / l)) [Pa]: the part of a strength f [Pa] that a band of length l [m] can soften from.
double admissible_strength(const RankineDamage& law, double strength, double band_length);

/// Admissible strength of the weakest direction in a band of length l [m]  [Pa].
double lowest_strength(const RankineDamage& law, double band_length);

/// D at the equivalent strain kappa [-] of an element of this strength [Pa] and band length [m]; 0 up to
/// onset.
double damage_of_strain(const RankineDamage& law, double strength, double band_length,
                        double equivalent_strain);

/// Share of its strength that an element has lost,  1 - (1 - D) M kappa / f_t,  0 to 1 [-].
double lost_strength(const RankineDamage& law, const DamageHistory& history);

/// kappa [-] at which an element of this strength [Pa] and band length [m] has lost `share`, 0 to 1, of its
/// strength. With exponential softening, which never loses all of it, the last 1e-12 is left.
double strain_of_lost_strength(const RankineDamage& law, double strength, double band_length, double share);

/// Energy spent per volume in uniaxial strain up to kappa,  integral of M k^2 / 2 dD(k)  [J/m3]; G_f / l at
/// the end.
double dissipated_energy(const RankineDamage& law, const DamageHistory& history);

/// History of an element whose crack would have this unit normal in a band of this length [m], undamaged.
DamageHistory undamaged_band(const RankineDamage& law, const std::array<double, 2>& normal,
                             double band_length);

/// The same at the onset of damage, the normal being the direction of the major principal stress, or nothing
/// while the undamaged stress [Pa] is below the strength of that direction.
std::optional<DamageHistory> damage_onset(const RankineDamage& law, const InPlane<double>& undamaged_stress,
                                          double band_length);

/// Lets the damage grow to the equivalent strain  major principal s / M  [-] if it is the largest so far.
void grow_damage(const RankineDamage& law, double equivalent_strain, DamageHistory& history);

/// Lets the damage grow to the undamaged stress [Pa] and returns the stress  s - D s+  [Pa].
InPlane<double> damaged_stress(const RankineDamage& law, const InPlane<double>& undamaged_stress,
                               DamageHistory& history);

}  // namespace fissura::structure
