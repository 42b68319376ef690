// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/moment_tensor.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::coupler {

namespace {

// Eigenvalues closer than this, relative to the greatest, are one: the axis across the plane then counts as
// the middle one, which is exact for shear-tensile sources.
constexpr double resolution = 1e-12;

double sum_of(const std::array<double, 3>& values) {
  return values[0] + values[1] + values[2];
}

double greatest_absolute(const std::array<double, 3>& values) {
  return std::max({std::abs(values[0]), std::abs(values[1]), std::abs(values[2])});
}

std::array<double, 3> deviatoric(const std::array<double, 3>& values) {
  const double mean = sum_of(values) / 3;
  return {values[0] - mean, values[1] - mean, values[2] - mean};
}

}  // namespace

PrincipalMoments principal_moments(const PlaneTensor& moment) {
  const auto [xx, yy, zz, xy] = moment;
  const double mean = 0.5 * (xx + yy);
  const double half_difference = 0.5 * (xx - yy);
  const double radius = std::hypot(half_difference, xy);
  const double major = mean + radius, minor = mean - radius;
  const double angle = 0.5 * std::atan2(xy, half_difference);
  const std::array<double, 3> along{std::cos(angle), std::sin(angle), 0};
  const std::array<double, 3> across{-along[1], along[0], 0};

  PrincipalMoments principal;
  principal.value = {major, minor, zz};
  std::sort(principal.value.begin(), principal.value.end(), std::greater<>());
  const double equal = resolution * greatest_absolute(principal.value);
  if (zz > major + equal)
    principal.axis = {{{0, 0, 1}, along, across}};
  else if (zz < minor - equal)
    principal.axis = {{along, across, {0, 0, 1}}};
  else
    principal.axis = {{along, {0, 0, -1}, across}};
  return principal;
}

double scalar_moment(const PlaneTensor& moment) {
  const auto [xx, yy, zz, xy] = moment;
  return std::sqrt(0.5 * (xx * xx + yy * yy + zz * zz) + xy * xy);
}

double scalar_moment_bowers_hudson(const PlaneTensor& moment) {
  const std::array<double, 3> values = principal_moments(moment).value;
  return std::abs(sum_of(values) / 3) + greatest_absolute(deviatoric(values));
}

double moment_magnitude(double scalar_moment) {
  return (std::log10(scalar_moment) - 9.1) * 2 / 3;
}

double moment_of_magnitude(double magnitude) {
  return std::pow(10, 1.5 * magnitude + 9.1);
}

Decomposition decomposition(const PrincipalMoments& moments) {
  const auto [m1, m2, m3] = moments.value;
  const double iso = (m1 + m2 + m3) / 3;
  const double clvd = (m1 + m3 - 2 * m2) * 2 / 3;
  const double dc = std::max(0.0, 0.5 * (m1 - m3 - std::abs(m1 + m3 - 2 * m2)));
  const double whole = std::abs(iso) + std::abs(clvd) + dc;
  if (whole == 0) return {};
  return {iso / whole, clvd / whole, dc / whole};
}

HudsonPoint hudson_point(const PrincipalMoments& moments) {
  const double scale = greatest_absolute(moments.value);
  if (scale == 0) return {};
  const auto [m1, m2, m3] = moments.value;
  return {-2 * (m1 + m3 - 2 * m2) / (3 * scale), (m1 + m2 + m3) / (3 * scale)};
}

HudsonTypes hudson_types(const PrincipalMoments& moments) {
  std::array<double, 3> ascending = deviatoric(moments.value);
  std::sort(ascending.begin(), ascending.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  const double iso = sum_of(moments.value) / 3;
  const double greatest = std::abs(ascending[2]);
  HudsonTypes types;
  if (greatest > 0) types.T = 2 * ascending[0] / greatest;
  if (iso != 0) types.k = iso / (std::abs(iso) + greatest);
  return types;
}

double slope_angle(const PrincipalMoments& moments) {
  const auto [m1, m2, m3] = moments.value;
  if (m1 == m3) return 0;
  return std::asin(std::clamp((m1 + m3 - 2 * m2) / (m1 - m3), -1.0, 1.0));
}

double lame_ratio(const Decomposition& shares) {
  return (shares.iso / shares.clvd + 1) * 4 / 3 - 2;
}

}  // namespace fissura::coupler
