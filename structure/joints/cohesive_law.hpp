// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace fissura::structure {

/// Cohesion of a breaking face pair with linear softening and coupled opening and sliding (Camacho & Ortiz 1996):
///   T(q) = f_t (1 - q / w_c),  w_c = 2 G_f / f_t,  q = max over time of sqrt(w^2 + s^2)
/// The energy spent on a face pair that is pulled apart is G_f.
struct CohesiveLaw {
  double strength = 0;         ///< f_t [Pa]; 0 = no cohesion
  double fracture_energy = 0;  ///< G_f [J/m2]; > 0 if strength > 0

  /// w_c [m]; 0 without cohesion.
  [[nodiscard]] double critical_opening() const;

  /// T(q) [Pa], 0 beyond w_c.
  [[nodiscard]] double envelope(double greatest_separation) const;

  [[nodiscard]] bool broken(double greatest_separation) const {
    return greatest_separation >= critical_opening();
  }

  /// Energy spent so far per area of face pair, the recoverable part left out [J/m2].
  [[nodiscard]] double spent_energy(double greatest_separation) const;
};

struct CohesiveTraction {
  double normal = 0;      ///< pulls the faces together, >= 0 [Pa]
  double tangential = 0;  ///< opposes the sliding; sign of `sliding` [Pa]
};

/// Cohesion at opening w [m] and sliding s [m] when the greatest separation so far (this one included) is q [m]. Unloading goes back
/// to the origin. Below `rigid_separation` the secant is not used, so that the law adds no stiffness that would bind the stable step.
CohesiveTraction cohesion(const CohesiveLaw& law, double opening, double sliding, double greatest_separation);

/// Separation below which the cohesion is constant in w [m].
inline constexpr double rigid_separation = 5e-6;
/// Smallest separation the tangential secant is taken at [m].
inline constexpr double tangential_separation = 2e-5;

/// Greatest stiffness -dT/dw of the unloading secant, per area [Pa/m]: it enters the stable step.
double secant_stiffness(const CohesiveLaw& law, double greatest_separation);

}  // namespace fissura::structure
