// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/joints/cohesive_law.hpp"

#include <algorithm>

namespace fissura::structure {

double CohesiveLaw::critical_opening() const { return strength > 0 ? 2 * fracture_energy / strength : 0; }

double CohesiveLaw::envelope(double greatest_separation) const {
  if (broken(greatest_separation)) return 0;
  return strength * (1 - greatest_separation / critical_opening());
}

double CohesiveLaw::spent_energy(double greatest_separation) const {
  const double q = std::min(greatest_separation, critical_opening());
  return strength * q / 2;
}

CohesiveTraction cohesion(const CohesiveLaw& law, double opening, double sliding, double greatest_separation) {
  const double traction = law.envelope(greatest_separation);
  if (traction == 0) return {};
  const double normal =
      greatest_separation > rigid_separation ? traction * opening / greatest_separation : traction;
  return {normal, traction * sliding / std::max(greatest_separation, tangential_separation)};
}

double secant_stiffness(const CohesiveLaw& law, double greatest_separation) {
  return law.envelope(greatest_separation) / std::max(greatest_separation, rigid_separation);
}

}  // namespace fissura::structure
