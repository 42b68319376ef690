// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "structure/fracture/crossing_criterion.hpp"
#include "structure/fracture/failure_path.hpp"
#include "structure/fracture/fracture_tips.hpp"
#include "structure/fracture/next_segment.hpp"

namespace fissura::structure {

/// What was decided when a fracture reached a natural one, with the numbers it was decided from. Whether it
/// crosses cannot come out of the mesh: an element is far larger than the zone in which the faces of the
/// natural fracture would slip, so that a tip of this size either always or never crosses. It is decided
/// once, before the two are connected, by the rule of the case.
struct Meeting {
  double time = 0;                 ///< [s]
  Point position{};                ///< of the junction [m]
  std::string hydraulic, natural;  ///< names of the lines
  InPlane<double> stress{};  ///< effective, acting there without the tip's own field, tension positive [Pa]
  double friction = 0;       ///< of the natural fracture [-]
  double cohesion = 0;       ///< of its faces, cement included [Pa]
  double strength = 0;       ///< tensile, of the rock [Pa]
  CrossingRule rule = CrossingRule::gu_weng;
  CrossingVerdict verdict;
  VertexIndex junction = 0;           ///< where they meet
  std::array<double, 2> direction{};  ///< in which the fracture came, mean over its last edges: unit vector
};

/// The decision for the fracture at `tip` that is about to join at `end`; nothing if no natural fracture is
/// there. Of several the one that lets it cross least decides.
std::optional<Meeting> meet(const RockNow& rock, const FractureTip& tip, const SegmentEnd& end, double time);

/// The seeds of the state as tips, in their order.
std::vector<FractureTip> crossing_tips(const Geometry& geometry, const std::vector<CrossingSeed>& seeds);

/// For the ACKNOWLEDGE of an INSERT (docs/protocol.md).
nlohmann::json meetings_json(const std::vector<Meeting>& meetings);

}  // namespace fissura::structure
