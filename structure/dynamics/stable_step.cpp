// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/stable_step.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <vector>

#include "common/errors.hpp"

namespace fissura::structure {

namespace {

using CornerValues = std::vector<std::array<double, 3>>;

constexpr int share_improvements = 2;

std::vector<Triangle> triangles(const Mesh& mesh) {
  std::vector<Triangle> shapes;
  shapes.reserve(mesh.elements.size());
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    shapes.push_back(triangle(mesh, element));
    if (shapes.back().area > 0) continue;
    const Point position = centroid(mesh, element);
    throw SolverError(
        fmt::format("an element with positive area was expected, element {} at ({} m, {} m) has {} m2",
                    element, position[0], position[1], shapes.back().area));
  }
  return shapes;
}

std::vector<double> sum_at_nodes(const Mesh& mesh, const CornerValues& values) {
  std::vector<double> sum(mesh.position.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (int i = 0; i < 3; ++i) sum[mesh.elements[e][i]] += values[e][i];
  return sum;
}

CornerValues areas(const std::vector<Triangle>& shapes) {
  CornerValues values;
  for (const auto& shape : shapes) values.push_back({shape.area, shape.area, shape.area});
  return values;
}

// Up to a factor, the trace of a corner's block of the stiffness matrix.
CornerValues corner_stiffness(const std::vector<Triangle>& shapes) {
  CornerValues values;
  for (const auto& shape : shapes) {
    const auto trace = [&shape](int i) {
      return shape.area * (shape.slope[i][0] * shape.slope[i][0] + shape.slope[i][1] * shape.slope[i][1]);
    };
    values.push_back({trace(0), trace(1), trace(2)});
  }
  return values;
}

}  // namespace

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
  const auto shapes = triangles(mesh);
  const auto area_at_nodes = sum_at_nodes(mesh, areas(shapes));
  CornerValues weight = corner_stiffness(shapes);
  StiffestElement best;
  for (int round = 0; round <= share_improvements; ++round) {
    const auto weight_at_nodes = sum_at_nodes(mesh, weight);
    StiffestElement stiffest;
    for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
      std::array<double, 3> mass{};
      for (int i = 0; i < 3; ++i) {
        const NodeIndex node = mesh.elements[element][i];
        mass[i] = density * area_at_nodes[node] / 3 * weight[element][i] / weight_at_nodes[node];
      }
      const double squared = element_frequency_squared(shapes[element], moduli, mass);
      if (squared > stiffest.frequency_squared) stiffest = {squared, element, centroid(mesh, element)};
      for (double& value : weight[element]) value *= squared;
    }
    if (round == 0 || stiffest.frequency_squared < best.frequency_squared) best = stiffest;
  }
  return best;
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
