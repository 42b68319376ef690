// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "structure/fracture/failure_map.hpp"
#include "structure/fracture/next_segment.hpp"

namespace fissura::structure {

/// The rock at a coupling time.
struct RockNow {
  const StructureModel& model;
  const Geometry& geometry;
  const StructureState& state;
};

/// Where a march begins and heads.
struct MarchStart {
  Point position{};                   ///< [m]
  NodeIndex node = 0;                 ///< at or next to it: the march stays in rock connected to this node
  std::array<double, 2> direction{};  ///< unit vector
};

/// The way on which rock breaks: steps of half a tip_size, each perpendicular to the greatest principal
/// stress of the average over the half disc ahead. The stress is the undamaged one: inside a failed band the
/// stress transmitted is near nothing, and what is left of it is decided by the flanks. A step turns by at
/// most 25 degrees, the first one and all together by at most Growth::turn_limit.
/// @returns the start and at most `steps` more points [m]; fewer where the march leaves the domain
std::vector<Point> march(const RockNow& rock, const MarchStart& start, int steps);

/// The failure path of a tip (Profit et al. 2016, Sect. 3.8): the march as far as the rock beside it has
/// failed, that is lost Growth::failure_damage of its strength. The first tip_size is not looked at: there
/// the fracture that came before took the failure away. The path becomes a fracture once it is
/// Growth::failure_length long, or where it ends on a side of the domain or on another fracture.
/// @returns ends of segments of one tip_size, at most four; nothing if the tip does not advance
std::optional<std::vector<SegmentEnd>> failure_path(const RockNow& rock, const FailureMap& map,
                                                    const FractureTip& tip);

}  // namespace fissura::structure
