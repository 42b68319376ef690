// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "common/case/case.hpp"
#include "structure/material/elasticity.hpp"

/// Whether a hydraulic fracture that reaches a natural one goes on beyond it.
namespace fissura::structure {

/// A hydraulic fracture that has just reached a natural one.
struct FractureMeeting {
  std::array<double, 2> hydraulic{};  ///< direction in which it came, unit vector
  std::array<double, 2> natural{};    ///< direction of the natural fracture, either way, unit vector
  InPlane<double> stress{};           ///< effective, without the tip's own field, tension positive [Pa]
  double friction = 0;                ///< mu of the natural fracture, tan(phi) [-]
  double cohesion = 0;                ///< c of its faces [Pa]
  double tensile_strength = 0;        ///< T_0 of the rock, > 0 [Pa]
};

struct CrossingVerdict {
  bool crosses = false;
  /// It would cross with every greater friction, all else equal; 0 if it crosses without any, nothing if no
  /// friction is enough.
  std::optional<double> critical_friction;
  double angle = 0;  ///< between the two, 0 to pi / 2 [rad]
};

/// The verdict of `rule`. With sigma_along and sigma_across the normal stresses of `stress` along and across
/// the hydraulic fracture (sigma_H and sigma_h if it follows the greatest compression) and the angle theta
/// between the two fractures it crosses if
///
///   renshaw_pollard   - sigma_along / (T_0 - sigma_across) > (.35 + .35 / mu) / 1.06
///   gu_weng           |tau| < c - mu sigma_n  (c if sigma_n >= 0)  on both sides of the tip
///   blanton           (sigma_across - sigma_along) / T_0 > -1 / (cos(2 theta) - b sin(2 theta)),  b = .2,
///   the right side positive
///
/// renshaw_pollard is derived for right angles and faces without cohesion; the angle does not enter it and
/// its answer elsewhere is that at a right angle. In gu_weng tau and sigma_n act on the natural fracture
/// under `stress` plus the mode I field of the tip, at the distance where their greatest principal stress is
/// T_0, on each of its two sides: at the angles beta and beta - pi from the direction of growth, as the
/// vectors give them. A stress that is not aligned with the hydraulic fracture therefore tells an inclination
/// to one side from one to the other. blanton knows no friction. Fractures along one another do not cross by
/// gu_weng and blanton.
///
/// C. E. Renshaw and D. D. Pollard, Int. J. Rock Mech. Min. Sci. 32 (1995) 237; H. Gu and X. Weng, ARMA
/// 10-198 (2010); T. L. Blanton, SPE 15261 (1986).
CrossingVerdict crossing_verdict(CrossingRule rule, const FractureMeeting& meeting);

}  // namespace fissura::structure
