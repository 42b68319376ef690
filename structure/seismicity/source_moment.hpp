// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "common/seismicity/source_record.hpp"
#include "structure/material/rock_failure.hpp"

/// Moments of what fails, as laws: no mesh, no state. Tension positive; plane strain has a zz component.
namespace fissura::structure {

/// Moment of a displacement discontinuity [N m],
///   M = A [ lambda (n . d) I + mu (n d + d n) ]                          (Aki & Richards 2002, sect. 3.3)
/// @param normal  unit vector from minus to plus  @param jump  u_plus - u_minus [m]  @param area  [m2]
PlaneTensor moment_of_jump(const Elasticity& moduli, const std::array<double, 2>& normal,
                           const std::array<double, 2>& jump, double area);

/// Stress that the rock would carry if its inelastic strain were elastic, less what it carries (the stress
/// glut of Backus & Mulcahy 1976): the moment of a volume [Pa],
///   g = (sigma_0 + C : eps) - sigma = C : eps_p + D s+ .
/// @param elastic  sigma_0 + C : eps [Pa]
PlaneTensor stress_glut(const PlaneStrainStress& elastic, const PlaneStrainStress& transmitted);

/// Traction on the side of a plane towards its unit normal; shear along (n_y, -n_x) [Pa].
struct PlaneTraction {
  double normal = 0, shear = 0;
};

PlaneTraction traction_on(const PlaneStrainStress& stress, const std::array<double, 2>& normal);

/// The part of a stress that a traction on a plane makes: no stress along the plane [Pa].
PlaneTensor stress_of(const PlaneTraction& traction, const std::array<double, 2>& normal);

/// Its components xx, yy, zz, xy [Pa].
PlaneTensor tensor_of(const PlaneStrainStress& stress);

inline PlaneTensor operator+(const PlaneTensor& a, const PlaneTensor& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
}
inline PlaneTensor operator-(const PlaneTensor& a, const PlaneTensor& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]};
}
inline PlaneTensor operator*(double factor, const PlaneTensor& a) {
  return {factor * a[0], factor * a[1], factor * a[2], factor * a[3]};
}

/// sqrt(sum M_ij^2 / 2)  (Silver & Jordan 1982), in the unit of the components.
double size_of(const PlaneTensor& tensor);

}  // namespace fissura::structure
