// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "common/case/case.hpp"
#include "structure/material/mohr_coulomb.hpp"
#include "structure/material/rankine_damage.hpp"

/// Mohr-Coulomb and Rankine as one surface whose tensile corner softens (Profit et al. 2016, Fig. 2; after
/// Klerck, Sellers & Owen 2004). Effective stresses, tension positive, plane strain. One step of an element:
///   predictor  s = sigma_0 + C : (eps - eps_p)
///   shear      s and eps_p return to Mohr-Coulomb, which bounds the stress transmitted, s - D s+
///   tension    kappa = max(kappa + dilatant extension, major principal s / M), D = D(kappa)
///   stress     sigma = s - D s+ ,  with D also on a tensile sigma_zz
/// Lowering a tensile stress never violates Mohr-Coulomb, so nothing is left to be checked. The dilatant
/// extension, the greatest in-plane principal value of the plastic strain increment, makes shear wear the
/// tensile strength down: axial splitting. The damage unloads along the secant and a closed crack is as stiff
/// as the rock; plastic strain stays.
namespace fissura::structure {

struct RockFailure {
  RankineDamage tension;
  std::optional<MohrCoulomb> shear;  ///< without it the rock fails in tension only
};

/// The law of a case. Throws InputError if the Mohr-Coulomb surface lies inside the tensile strength, so that
/// rock in tension would shear before it cracks.
RockFailure rock_failure(const Rock& rock, const BulkFailure& settings);

/// What an element that has sheared remembers beside its DamageHistory.
struct PlasticHistory {
  InPlane<double> strain{};  ///< eps_p, with gamma_xy [-]
  double strain_zz = 0;      ///< [-]
  double work = 0;           ///< of the stress on the plastic strain so far [J/m3]
  double worn = 0;           ///< fracture energy that shear took off without spending it [J/m3]
};

/// Size of the plastic strain,  sqrt(2/3 eps_p : eps_p)  [-].
double size_of(const PlasticHistory& plastic);

/// Predictor [Pa]: `elastic`, sigma_0 + C : eps, less C : eps_p.
PlaneStrainStress without_plastic_part(const Elasticity& moduli, const PlaneStrainStress& elastic,
                                       const PlasticHistory& plastic);

/// sigma = s - D s+  [Pa], the tensile part taken in the plane and of sigma_zz.
PlaneStrainStress transmitted_stress(const PlaneStrainStress& undamaged, double damage);

/// History of an element that leaves its elastic range at this stress [Pa], or nothing while it is inside
/// both surfaces. `corner` are its corners [m], counter-clockwise; the crack band takes its normal from the
/// major principal stress in the plane.
std::optional<DamageHistory> failure_onset(const RockFailure& law, const PlaneStrainStress& elastic,
                                           const std::array<std::array<double, 2>, 3>& corner);

/// Lets an element that has left its elastic range shear and crack, and returns its stress [Pa]. `elastic` is
/// sigma_0 + C : eps [Pa].
PlaneStrainStress failed_stress(const RockFailure& law, const PlaneStrainStress& elastic,
                                DamageHistory& damage, PlasticHistory& plastic);

/// Energy spent on damage and plastic flow [J/m3].
double dissipated_energy(const RockFailure& law, const DamageHistory& damage, const PlasticHistory& plastic);

}  // namespace fissura::structure
