// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/seismicity/source_moment.hpp"

#include <cmath>

namespace fissura::structure {

PlaneTensor moment_of_jump(const Elasticity& moduli, const std::array<double, 2>& normal,
                           const std::array<double, 2>& jump, double area) {
  const auto [nx, ny] = normal;
  const auto [dx, dy] = jump;
  const double mean = area * moduli.lame * (nx * dx + ny * dy), shear = area * moduli.shear;
  return {mean + 2 * shear * nx * dx, mean + 2 * shear * ny * dy, mean, shear * (nx * dy + ny * dx)};
}

PlaneTensor stress_glut(const PlaneStrainStress& elastic, const PlaneStrainStress& transmitted) {
  return tensor_of(elastic) - tensor_of(transmitted);
}

PlaneTraction traction_on(const PlaneStrainStress& stress, const std::array<double, 2>& normal) {
  const auto& [xx, yy, xy] = stress.in_plane;
  const auto [nx, ny] = normal;
  const double tx = xx * nx + xy * ny, ty = xy * nx + yy * ny;
  return {tx * nx + ty * ny, tx * ny - ty * nx};
}

PlaneTensor stress_of(const PlaneTraction& traction, const std::array<double, 2>& normal) {
  const auto [nx, ny] = normal;
  return {traction.normal * nx * nx + 2 * traction.shear * nx * ny,
          traction.normal * ny * ny - 2 * traction.shear * nx * ny, 0,
          traction.normal * nx * ny + traction.shear * (ny * ny - nx * nx)};
}

PlaneTensor tensor_of(const PlaneStrainStress& stress) {
  return {stress.in_plane.xx, stress.in_plane.yy, stress.out_of_plane, stress.in_plane.xy};
}

double size_of(const PlaneTensor& tensor) {
  const auto [xx, yy, zz, xy] = tensor;
  return std::sqrt((xx * xx + yy * yy + zz * zz) / 2 + xy * xy);
}

}  // namespace fissura::structure
