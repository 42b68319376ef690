// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/crossing_criterion.hpp"

#include <algorithm>
#include <cmath>

#include "structure/material/mohr_circle.hpp"

namespace fissura::structure {

namespace {

using Vector = std::array<double, 2>;

/// Components along and across a unit vector.
InPlane<double> in_frame(const InPlane<double>& stress, const Vector& along) {
  const double c = along[0], s = along[1];
  return {c * c * stress.xx + s * s * stress.yy + 2 * c * s * stress.xy,
          s * s * stress.xx + c * c * stress.yy - 2 * c * s * stress.xy,
          c * s * (stress.yy - stress.xx) + (c * c - s * s) * stress.xy};
}

double angle_between(const Vector& a, const Vector& b) {
  return std::atan2(std::abs(a[0] * b[1] - a[1] * b[0]), std::abs(a[0] * b[0] + a[1] * b[1]));
}

/// Mode I field at the angle `theta` from the direction of growth, for K_I / sqrt(2 pi r) = 1 (M. L. Williams
/// 1957).
InPlane<double> opening_field(double theta) {
  const double c = std::cos(theta / 2), s = std::sin(theta / 2);
  const double c3 = std::cos(1.5 * theta), s3 = std::sin(1.5 * theta);
  return {c * (1 - s * s3), c * (1 + s * s3), c * s * c3};
}

/// The k >= 0 with which the greatest principal stress of `remote` + k `field` is `strength`: the lesser root
/// of
///   det(strength I - remote - k field) = 0 .
std::optional<double> scale_to_strength(const InPlane<double>& remote, const InPlane<double>& field,
                                        double strength) {
  if (principal(remote).major >= strength) return 0;
  const double xx = strength - remote.xx, yy = strength - remote.yy;
  const double quadratic = field.xx * field.yy - field.xy * field.xy;
  const double linear = xx * field.yy + yy * field.xx + 2 * remote.xy * field.xy;
  const double constant = xx * yy - remote.xy * remote.xy;
  if (linear <= 0) return std::nullopt;
  return 2 * constant / (linear + std::sqrt(std::max(0.0, linear * linear - 4 * quadratic * constant)));
}

/// Least friction that holds faces under these stresses together; nothing if none does.
std::optional<double> holding_friction(double normal, double shear, double cohesion) {
  const double excess = std::abs(shear) - cohesion;
  if (excess < 0) return 0;
  if (normal >= 0) return std::nullopt;
  return excess / -normal;
}

std::optional<double> renshaw_pollard(const FractureMeeting& meeting) {
  const InPlane<double> stress = in_frame(meeting.stress, meeting.hydraulic);
  if (stress.xx >= 0) return std::nullopt;
  const double resistance = meeting.tensile_strength - stress.yy;
  if (resistance <= 0) return 0;
  const double excess = 1.06 * -stress.xx / resistance - 0.35;
  if (excess <= 0) return std::nullopt;
  return 0.35 / excess;
}

std::optional<double> gu_weng(const FractureMeeting& meeting) {
  const Vector &growth = meeting.hydraulic, &natural = meeting.natural;
  const InPlane<double> remote = in_frame(meeting.stress, growth);
  const Vector arm{growth[0] * natural[0] + growth[1] * natural[1],
                   growth[0] * natural[1] - growth[1] * natural[0]};
  constexpr double parallel = 1e-9;
  if (std::abs(arm[1]) < parallel) return std::nullopt;
  double least = 0;
  for (const Vector& side : {arm, Vector{-arm[0], -arm[1]}}) {
    const InPlane<double> field = opening_field(std::atan2(side[1], side[0]));
    const auto scale = scale_to_strength(remote, field, meeting.tensile_strength);
    if (!scale) return std::nullopt;
    const InPlane<double> on_faces = in_frame(
        {remote.xx + *scale * field.xx, remote.yy + *scale * field.yy, remote.xy + *scale * field.xy}, side);
    const auto friction = holding_friction(on_faces.yy, on_faces.xy, meeting.cohesion);
    if (!friction) return std::nullopt;
    least = std::max(least, *friction);
  }
  return least;
}

std::optional<double> blanton(const FractureMeeting& meeting, double angle) {
  constexpr double b = 0.2;
  const InPlane<double> stress = in_frame(meeting.stress, meeting.hydraulic);
  const double steepness = b * std::sin(2 * angle) - std::cos(2 * angle);
  if (steepness * (stress.yy - stress.xx) > meeting.tensile_strength && steepness > 0) return 0;
  return std::nullopt;
}

}  // namespace

CrossingVerdict crossing_verdict(CrossingRule rule, const FractureMeeting& meeting) {
  CrossingVerdict verdict;
  verdict.angle = angle_between(meeting.hydraulic, meeting.natural);
  switch (rule) {
    case CrossingRule::renshaw_pollard:
      verdict.critical_friction = renshaw_pollard(meeting);
      break;
    case CrossingRule::gu_weng:
      verdict.critical_friction = gu_weng(meeting);
      break;
    case CrossingRule::blanton:
      verdict.critical_friction = blanton(meeting, verdict.angle);
      break;
    case CrossingRule::always:
      verdict.critical_friction = 0;
      break;
    case CrossingRule::never:
      break;
  }
  verdict.crosses = verdict.critical_friction &&
                    (*verdict.critical_friction == 0 || meeting.friction > *verdict.critical_friction);
  return verdict;
}

}  // namespace fissura::structure
