// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "structure/material/elasticity.hpp"
#include "structure/mesh/mesh.hpp"

/// The constant-strain triangle. Its shape functions N_i are linear, so strain and stress are constant in it
/// (Zienkiewicz & Taylor, The Finite Element Method, ch. 2).
namespace fissura::structure {

struct Triangle {
  double area = 0;                               ///< [m2]
  std::array<std::array<double, 2>, 3> slope{};  ///< grad N_i [1/m]
};

/// Shape of an element in the undeformed mesh.
inline Triangle triangle(const Mesh& mesh, ElementIndex element) {
  const auto& [a, b, c] = mesh.elements[element];
  const Point &p = mesh.position[a], &q = mesh.position[b], &r = mesh.position[c];
  const double double_area = (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
  return {0.5 * double_area,
          {{{(q[1] - r[1]) / double_area, (r[0] - q[0]) / double_area},
            {(r[1] - p[1]) / double_area, (p[0] - r[0]) / double_area},
            {(p[1] - q[1]) / double_area, (q[0] - p[0]) / double_area}}}};
}

/// Mean of the corners [m].
inline Point centroid(const Mesh& mesh, ElementIndex element) {
  Point mean{};
  for (const NodeIndex node : mesh.elements[element])
    for (int axis = 0; axis < 2; ++axis) mean[axis] += mesh.position[node][axis] / 3;
  return mean;
}

/// Strain (with gamma_xy) of an element; `displacement` is interleaved x, y per node [m].
inline InPlane<double> strain(const Mesh& mesh, ElementIndex element, const Triangle& shape,
                              const std::vector<double>& displacement) {
  InPlane<double> result{0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    const double* u = displacement.data() + 2 * mesh.elements[element][i];
    result.xx += shape.slope[i][0] * u[0];
    result.yy += shape.slope[i][1] * u[1];
    result.xy += shape.slope[i][0] * u[1] + shape.slope[i][1] * u[0];
  }
  return result;
}

}  // namespace fissura::structure
