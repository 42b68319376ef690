// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/coupling/displacement_discontinuity.hpp"

#include <Eigen/Dense>
#include <numbers>

namespace fissura {

namespace {

struct PlaneStress {
  double xx = 0, yy = 0, xy = 0;
};

// Edge dislocations with unit Burgers vector across (y) and along (x) the element; Hirth & Lothe, chapter 3, without E'/(4 pi).
PlaneStress dislocation_across(double x, double y) {
  const double r2 = x * x + y * y, r4 = r2 * r2, difference = x * x - y * y;
  return {x * difference / r4, x * (r2 + 2 * y * y) / r4, y * difference / r4};
}

PlaneStress dislocation_along(double x, double y) {
  const double r2 = x * x + y * y, r4 = r2 * r2, difference = x * x - y * y;
  return {-y * (r2 + 2 * x * x) / r4, y * difference / r4, x * difference / r4};
}

PlaneStress operator-(const PlaneStress& a, const PlaneStress& b) { return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy}; }

struct Traction {
  double normal = 0, shear = 0;
};

/// Traction on `field` of a stress given in the axes of `source`.
Traction traction_on(const DiscontinuityElement& field, const DiscontinuityElement& source, const PlaneStress& stress) {
  const double cosine = source.tangent_x * field.tangent_x + source.tangent_y * field.tangent_y;
  const double sine = source.tangent_x * field.tangent_y - source.tangent_y * field.tangent_x;
  return {stress.xx * sine * sine + stress.yy * cosine * cosine - 2 * stress.xy * sine * cosine,
          (stress.yy - stress.xx) * sine * cosine + stress.xy * (cosine * cosine - sine * sine)};
}

}  // namespace

std::vector<double> opening_under_unit_pressure(const std::vector<DiscontinuityElement>& elements,
                                                double plane_strain_modulus) {
  const auto n = static_cast<Eigen::Index>(elements.size());
  const double scale = plane_strain_modulus / (4 * std::numbers::pi);
  Eigen::MatrixXd influence(2 * n, 2 * n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const DiscontinuityElement &field = elements[static_cast<std::size_t>(i)],
                                 &source = elements[static_cast<std::size_t>(j)];
      const double dx = field.x - source.x, dy = field.y - source.y;
      const double x = dx * source.tangent_x + dy * source.tangent_y;
      const double y = -dx * source.tangent_y + dy * source.tangent_x;
      const double a = source.half_length;
      const Traction opening =
          traction_on(field, source, dislocation_across(x - a, y) - dislocation_across(x + a, y));
      const Traction sliding =
          traction_on(field, source, dislocation_along(x - a, y) - dislocation_along(x + a, y));
      influence(2 * i, 2 * j) = scale * opening.normal;
      influence(2 * i, 2 * j + 1) = scale * sliding.normal;
      influence(2 * i + 1, 2 * j) = scale * opening.shear;
      influence(2 * i + 1, 2 * j + 1) = scale * sliding.shear;
    }
  Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * n);
  for (Eigen::Index i = 0; i < n; ++i) load(2 * i) = -1;
  const Eigen::VectorXd discontinuity = influence.partialPivLu().solve(load);
  std::vector<double> opening(elements.size());
  for (Eigen::Index i = 0; i < n; ++i) opening[static_cast<std::size_t>(i)] = discontinuity(2 * i);
  return opening;
}

}  // namespace fissura
