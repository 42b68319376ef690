// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/hoop_direction.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "structure/dynamics/element_fields.hpp"
#include "structure/dynamics/triangle.hpp"
#include "structure/fracture/connected_elements.hpp"
#include "structure/fracture/triangle_integral.hpp"

namespace fissura::structure {

namespace {

constexpr double pi = std::numbers::pi, degree = pi / 180;
constexpr double inner = 1, outer = 4, beside_faces = 150 * degree;          // of the fit; radii in h
constexpr double cone_radius = 2, cone_width = 1, cone_angle = 20 * degree;  // of the stress across a kink

struct Polar {
  double radius = 0, angle = 0;
};

/// From the end, the angle counter-clockwise from its direction.
Polar polar(const FractureEnd& end, const Point& at) {
  const double x = at[0] - end.centre[0], y = at[1] - end.centre[1];
  return {std::hypot(x, y), std::atan2(end.direction[0] * y - end.direction[1] * x,
                                       end.direction[0] * x + end.direction[1] * y)};
}

InPlane<double> total_stress(const Mesh& mesh, const Body& body, const Elasticity& moduli,
                             const std::vector<double>& displacement, ElementIndex element) {
  InPlane<double> stress = undamaged_stress(mesh, body, moduli, element, displacement).in_plane;
  stress.xx -= body.in_situ[element].pore_pressure;
  stress.yy -= body.in_situ[element].pore_pressure;
  return stress;
}

/// Components in the frame whose first axis is the unit vector `along`.
Eigen::Vector3d in_frame(const InPlane<double>& stress, const std::array<double, 2>& along) {
  const double c = along[0], s = along[1];
  return {c * c * stress.xx + s * s * stress.yy + 2 * c * s * stress.xy,
          s * s * stress.xx + c * c * stress.yy - 2 * c * s * stress.xy,
          c * s * (stress.yy - stress.xx) + (c * c - s * s) * stress.xy};
}

/// Williams' terms of order r^(m - 1), m = n / 2 for odd n, xx, yy and xy for unit coefficients: first the
/// symmetric one, then the antisymmetric one.
Eigen::Matrix<double, 3, 2> williams(double m, const Polar& at) {
  const double c1 = std::cos((m - 1) * at.angle), s1 = std::sin((m - 1) * at.angle);
  const double c3 = std::cos((m - 3) * at.angle), s3 = std::sin((m - 3) * at.angle);
  Eigen::Matrix<double, 3, 2> terms;
  terms << (1 + m) * c1 - (m - 1) * c3, -((3 + m) * s1 - (m - 1) * s3),  //
      (3 - m) * c1 + (m - 1) * c3, -((1 - m) * s1 + (m - 1) * s3),       //
      (m - 1) * s3 - (m - 1) * s1, (m - 1) * c3 - (m + 1) * c1;
  return m * std::pow(at.radius, m - 1) * terms;
}

}  // namespace

StressIntensity stress_intensity(const Mesh& mesh, const NodeElements& node_elements, const Body& body,
                                 const Elasticity& moduli, const std::vector<double>& displacement,
                                 const FractureEnd& end) {
  constexpr int terms = 7;
  Eigen::Matrix<double, terms, terms> normal = Eigen::Matrix<double, terms, terms>::Zero();
  Eigen::Matrix<double, terms, 1> right = Eigen::Matrix<double, terms, 1>::Zero();
  for (const ElementIndex element :
       connected_elements(mesh, node_elements, end.node, end.centre, outer * end.h)) {
    Polar at = polar(end, centroid(mesh, element));
    at.radius /= end.h;
    if (at.radius < inner || at.radius > outer || std::abs(at.angle) > beside_faces) continue;
    Eigen::Matrix<double, 3, terms> field;
    field << williams(0.5, at), williams(1.5, at), Eigen::Matrix3d::Identity();
    const double area = triangle(mesh, element).area;
    const Eigen::Vector3d stress =
        in_frame(total_stress(mesh, body, moduli, displacement, element), end.direction);
    normal += area * field.transpose() * field;
    right += area * field.transpose() * stress;
  }
  const Eigen::Matrix<double, terms, 1> best = normal.completeOrthogonalDecomposition().solve(right);
  const double scale = std::sqrt(2 * pi * end.h);
  return {scale * best[0], -scale * best[1]};
}

double greatest_hoop_angle(const StressIntensity& intensity) {
  const double opening = std::max(0.0, intensity.opening), sliding = intensity.sliding;
  if (sliding == 0) return 0;
  return 2 * std::atan((opening - std::sqrt(opening * opening + 8 * sliding * sliding)) / (4 * sliding));
}

Kink greatest_hoop_kink(const Mesh& mesh, const NodeElements& node_elements, const Body& body,
                        const Elasticity& moduli, const std::vector<double>& displacement,
                        const FractureEnd& end) {
  const double angle =
      greatest_hoop_angle(stress_intensity(mesh, node_elements, body, moduli, displacement, end));
  const double c = std::cos(angle), s = std::sin(angle);
  const std::array<double, 2> direction{c * end.direction[0] - s * end.direction[1],
                                        s * end.direction[0] + c * end.direction[1]};
  const auto weight = [&](const Point& place) {
    const Polar at = polar(end, place);
    const double distance = at.radius / (cone_width * end.h), turn = (at.angle - angle) / cone_angle;
    if (at.radius > cone_radius * end.h) return 0.0;
    return std::exp(-(distance * distance + turn * turn) / 2);
  };
  double sum = 0, weights = 0;
  for (const ElementIndex element :
       connected_elements(mesh, node_elements, end.node, end.centre, cone_radius * end.h)) {
    const auto& [p, q, r] = mesh.elements[element];
    const double share = integral_over({mesh.position[p], mesh.position[q], mesh.position[r]},
                                       triangle(mesh, element).area, weight);
    sum += share * in_frame(total_stress(mesh, body, moduli, displacement, element), direction)[1];
    weights += share;
  }
  return {direction, sum / weights};
}

}  // namespace fissura::structure
