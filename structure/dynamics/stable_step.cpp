// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/stable_step.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "structure/dynamics/frequency_bound.hpp"

namespace fissura::structure {

double element_frequency_squared(const Triangle& shape, const Elasticity& moduli,
                                 const std::array<double, 3>& corner_mass) {
  double xx = 0, yy = 0, xy = 0;
  for (int i = 0; i < 3; ++i) {
    const auto& slope = shape.slope[i];
    xx += slope[0] * slope[0] / corner_mass[i];
    yy += slope[1] * slope[1] / corner_mass[i];
    xy += slope[0] * slope[1] / corner_mass[i];
  }
  Eigen::Matrix3d mobility, stiffness;
  mobility << xx, 0, xy, 0, yy, xy, xy, xy, xx + yy;
  const double axial = moduli.lame + 2 * moduli.shear;
  stiffness << axial, moduli.lame, 0, moduli.lame, axial, 0, 0, 0, moduli.shear;
  const Eigen::Matrix3d factor = stiffness.llt().matrixL();
  // C G has the eigenvalues of the symmetric L^T G L
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(factor.transpose() * mobility * factor,
                                                             Eigen::EigenvaluesOnly);
  return shape.area * modes.eigenvalues()[2];
}

StiffestElement stiffest_element(const Mesh& mesh, const Elasticity& moduli, double density) {
  return stiffest_element(mesh, bound_frequencies(mesh, moduli, density));
}

double pair_frequency_squared(double stiffness, double mass_a, double mass_b) {
  return stiffness * (1 / mass_a + 1 / mass_b);
}

double stable_step(double element_frequency_squared, double spring_frequency_squared,
                   const StepConditions& conditions) {
  const double squared = (element_frequency_squared + spring_frequency_squared) * (1 + conditions.damping);
  return conditions.safety_factor * 2 * std::sqrt(conditions.mass_scale / squared);
}

}  // namespace fissura::structure
