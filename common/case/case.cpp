// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/case.hpp"

#include <algorithm>
#include <cmath>

namespace fissura {

std::array<double, 3> in_plane_stress(const InSitu& in_situ, const Point& at) {
  std::array<double, 3> stress{};
  for (std::size_t i = 0; i < stress.size(); ++i)
    stress[i] =
        in_situ.stress[i] + in_situ.stress_gradient[i][0] * at[0] + in_situ.stress_gradient[i][1] * at[1];
  return stress;
}

double pore_pressure(const InSitu& in_situ, const Point& at) {
  return in_situ.pore_pressure + in_situ.pore_pressure_gradient[0] * at[0] +
         in_situ.pore_pressure_gradient[1] * at[1];
}

double tip_strength(double tensile_strength, double fracture_energy, double plane_strain_modulus, double h) {
  constexpr double cells_per_zone = 1.5;
  return std::min(tensile_strength, std::sqrt(plane_strain_modulus * fracture_energy / (cells_per_zone * h)));
}

}  // namespace fissura
