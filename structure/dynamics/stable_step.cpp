// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/stable_step.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "common/errors.hpp"

namespace fissura::structure {

double element_frequency_squared(const Triangle& shape, const Elasticity& moduli, double density) {
  double xx = 0, yy = 0, xy = 0;
  for (const auto& slope : shape.slope) {
    xx += slope[0] * slope[0];
    yy += slope[1] * slope[1];
    xy += slope[0] * slope[1];
  }
  Eigen::Matrix3d gram, stiffness;
  gram << xx, 0, xy, 0, yy, xy, xy, xy, xx + yy;
  const double axial = moduli.lame + 2 * moduli.shear;
  stiffness << axial, moduli.lame, 0, moduli.lame, axial, 0, 0, 0, moduli.shear;
  const Eigen::Matrix3d factor = stiffness.llt().matrixL();
  // C G has the eigenvalues of the symmetric L^T G L
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(factor.transpose() * gram * factor,
                                                             Eigen::EigenvaluesOnly);
  return 3 / density * modes.eigenvalues()[2];
}

StiffestElement stiffest_element(const Mesh& mesh, const Elasticity& moduli, double density) {
  StiffestElement stiffest;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const auto shape = triangle(mesh, element);
    const Point position = centroid(mesh, element);
    if (!(shape.area > 0))
      throw SolverError(
          fmt::format("an element with positive area was expected, element {} at ({} m, {} m) has {} m2",
                      element, position[0], position[1], shape.area));
    const double squared = element_frequency_squared(shape, moduli, density);
    if (squared > stiffest.frequency_squared) stiffest = {squared, element, position};
  }
  return stiffest;
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
