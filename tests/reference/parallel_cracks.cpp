// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/parallel_cracks.hpp"

#include <Eigen/Dense>
#include <numbers>

namespace fissura::reference::parallel_cracks {

namespace {

/// Derivatives of the potential of a cell, E' / 4 pi taken out.
struct Potential {
  double yy, xyy, yyy;

  Potential(double x, double y, double a) {
    const double l = x - a, r = x + a, l2 = l * l + y * y, r2 = r * r + y * y;
    yy = -(l / l2 - r / r2);
    xyy = (l * l - y * y) / (l2 * l2) - (r * r - y * y) / (r2 * r2);
    yyy = 2 * y * (l / (l2 * l2) - r / (r2 * r2));
  }
};

/// Half-length and E' / 4 pi of 1, pressure 1; the other crack lies `spacing` below with the same opening and
/// the sliding of a mirror.
double middle_opening(double spacing, int cells) {
  const double a = 1.0 / cells;
  Eigen::MatrixXd matrix(2 * cells, 2 * cells);
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const double x = 2 * a * (i - j);
      const Potential own(x, 0, a), other(x, spacing, a);
      const double d = spacing;
      // Rows: -sigma_yy, sigma_xy; columns: opening, sliding.
      matrix(i, j) = own.yy + (other.yy - d * other.yyy);
      matrix(i, cells + j) = -d * other.xyy;
      matrix(cells + i, j) = d * other.xyy;
      matrix(cells + i, cells + j) = own.yy - (other.yy + d * other.yyy);
    }
  Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * cells);
  load.head(cells).setOnes();
  return Eigen::VectorXd(matrix.partialPivLu().solve(load))(cells / 2);
}

}  // namespace

double relative_middle_opening(double spacing, int cells) {
  constexpr double far_apart = 1e6;
  return middle_opening(spacing, cells) / middle_opening(far_apart, cells);
}

}  // namespace fissura::reference::parallel_cracks
