// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "coupler/seismicity/moment_tensor.hpp"

namespace fissura::coupler {

namespace {

using Vector = std::array<double, 3>;

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-9;  // of a component of a unit vector; below it counts as 0

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector scaled(double factor, const Vector& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}

double snapped(double component) {
  return std::abs(component) < rounding ? 0 : component;
}

/// Components to the east, north and up of a unit vector.
Vector geographic(const Vector& unit, const Geography& geography) {
  return {snapped(dot(unit, geography.east)), snapped(dot(unit, geography.north)),
          snapped(dot(unit, geography.up))};
}

/// Whether the strike is to be told from this side.
bool upward(const Vector& a) {
  if (a[2] != 0) return a[2] > 0;
  const double to_south_east = snapped(a[0] - a[1]);
  return to_south_east != 0 ? to_south_east > 0 : a[0] < 0;
}

double positive_angle(double angle) {
  const double turned = angle < 0 ? angle + 2 * pi : angle;
  return turned < 2 * pi ? turned : 0;
}

double product(const PlaneTensor& moment, const Vector& a, const Vector& b) {
  return moment[0] * a[0] * b[0] + moment[1] * a[1] * b[1] + moment[2] * a[2] * b[2] +
         moment[3] * (a[0] * b[1] + a[1] * b[0]);
}

}  // namespace

NodalPlane nodal_plane(const Vector& normal, const Vector& slip, const Geography& geography) {
  const double length = std::sqrt(dot(slip, slip));
  Vector n = geographic(normal, geography);
  Vector d = length > 0 ? geographic(scaled(1 / length, slip), geography) : Vector{};
  if (!upward(n)) {
    n = scaled(-1, n);
    d = scaled(-1, d);
  }
  NodalPlane plane;
  const double horizontal = std::hypot(n[0], n[1]);
  plane.dip = std::atan2(horizontal, n[2]);
  plane.strike = horizontal > 0 ? positive_angle(std::atan2(-n[1], n[0])) : 0;
  const Vector along{std::sin(plane.strike), std::cos(plane.strike), 0};
  const double along_strike = snapped(dot(d, along));
  const double up_dip = snapped(dot(d, cross(n, along)));
  plane.rake = up_dip == 0 ? (along_strike < 0 ? pi : 0) : std::atan2(up_dip, along_strike);
  return plane;
}

std::array<NodalPlane, 2> nodal_planes(const PrincipalMoments& moments, const Vector& true_normal,
                                       const Geography& geography) {
  const Vector& tension = moments.axis[0];
  const Vector& pressure = moments.axis[2];
  Vector normal{}, slip{};
  for (std::size_t i = 0; i < 3; ++i) {
    normal[i] = (tension[i] + pressure[i]) / std::numbers::sqrt2;
    slip[i] = (tension[i] - pressure[i]) / std::numbers::sqrt2;
  }
  const NodalPlane first = nodal_plane(normal, slip, geography);
  const NodalPlane second = nodal_plane(slip, normal, geography);
  if (std::abs(dot(slip, true_normal)) > std::abs(dot(normal, true_normal))) return {second, first};
  return {first, second};
}

std::array<double, 6> up_south_east(const PlaneTensor& moment, const Geography& geography) {
  const Vector& r = geography.up;
  const Vector t = scaled(-1, geography.north);
  const Vector& p = geography.east;
  return {product(moment, r, r), product(moment, t, t), product(moment, p, p),
          product(moment, r, t), product(moment, r, p), product(moment, t, p)};
}

AxisDirection axis_direction(const Vector& axis, const Geography& geography) {
  Vector a = geographic(axis, geography);
  if (a[2] > 0 || (a[2] == 0 && (a[0] < 0 || (a[0] == 0 && a[1] < 0)))) a = scaled(-1, a);
  const double horizontal = std::hypot(a[0], a[1]);
  AxisDirection direction;
  direction.plunge = a[2] == 0 ? 0 : std::atan2(-a[2], horizontal);
  if (horizontal > 0) direction.azimuth = positive_angle(std::atan2(a[0], a[1]));
  return direction;
}

}  // namespace fissura::coupler
