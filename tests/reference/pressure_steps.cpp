// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/pressure_steps.hpp"

#include <cmath>

namespace fissura::reference::pressure_steps {

Points points(int count) {
  Points result{Eigen::VectorXd(count), Eigen::VectorXd(count)};
  for (int i = 0; i < count; ++i) {
    const double u = (i + 0.5) / count;
    result.gap(i) = std::pow(u, 9);
    result.weight(i) = 9 * std::pow(u, 8) / count;
  }
  return result;
}

double chord(double gap) {
  return std::sqrt(gap * (2 - gap));
}

double angle(double gap) {
  return 2 * std::asin(std::sqrt(gap / 2));
}

double lost_opening(double gap, double gap_of_step) {
  const double x = 1 - gap, b = 1 - gap_of_step, c = chord(gap), d = chord(gap_of_step);
  if (gap == gap_of_step) return 2 * c * angle(gap) + 2 * b * std::log(b);
  const double ratio = std::abs((c + d) / (c - d));
  const double crossed = std::abs((b * c + x * d) / ((c - d) - gap_of_step * c + gap * d));
  return 2 * c * angle(gap_of_step) - b * std::log(ratio) + x * std::log(crossed);
}

double lost_volume(double gap_of_step) {
  const double a = angle(gap_of_step);
  return a < 1e-3 ? a * a * a / 3 : (2 * a - std::sin(2 * a)) / 4;
}

Eigen::MatrixXd lost_openings(const Points& points) {
  const Eigen::Index count = points.gap.size();
  Eigen::MatrixXd result(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < count; ++j) result(i, j) = lost_opening(points.gap(i), points.gap(j));
  return result;
}

}  // namespace fissura::reference::pressure_steps
