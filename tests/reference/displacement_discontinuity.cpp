// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/displacement_discontinuity.hpp"

#include <numbers>

namespace fissura::reference::displacement_discontinuity {
namespace {

// Of one cell of opening 1 with its centre at the origin; `x` on the line, E' = 1.
double pressure_of_cell(double x, double half_length) {
  return -(1 / (x - half_length) - 1 / (x + half_length)) / (4 * std::numbers::pi);
}

}  // namespace

std::vector<double> centres(const std::vector<double>& edges) {
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) result.push_back((edges[i] + edges[i + 1]) / 2);
  return result;
}

std::vector<double> lengths(const std::vector<double>& edges) {
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) result.push_back(edges[i + 1] - edges[i]);
  return result;
}

Eigen::MatrixXd stiffness(const std::vector<double>& edges, double plane_strain_modulus) {
  const auto x = centres(edges), length = lengths(edges);
  const auto n = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixXd a(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      a(i, j) = plane_strain_modulus * pressure_of_cell(x[i] - x[j], length[j] / 2);
  return a;
}

}  // namespace fissura::reference::displacement_discontinuity
