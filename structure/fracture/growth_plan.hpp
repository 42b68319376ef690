// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "common/fracture_network/fracture_network.hpp"
#include "structure/fracture/meeting.hpp"
#include "structure/fracture/patch_plan.hpp"
#include "structure/structure_state.hpp"

namespace fissura::structure {

/// What grows at one coupling time: a patch for each tip that advances. Patches share no node.
struct GrowthPlan {
  std::vector<PatchPlan> patches;
  std::vector<FractureLine> new_lines;     ///< of fractures that grow for the first time
  std::vector<Meeting> meetings;           ///< with natural fractures that patches end on
  std::vector<std::size_t> meeting_patch;  ///< of each, index into `patches`
  Insertion insertion;                     ///< how the fluid's network changes
  double wall_seconds = 0;                 ///< of planning
};

/// Tips are the ends of open lines and of what grew, the ends of natural fractures that have slid or opened,
/// and the far sides of natural fractures that a fracture may cross (meeting.hpp). Early insertion of wet
/// cohesive segments, for every tip at which
///   sigma_1(average over a half disc of 2 h) + p >= trigger f_t,tip ,
/// p the fluid pressure on the faces of the last open vertex, at least that of the pores. The segment is
/// perpendicular to the greatest principal stress of the average over 3 h, weighted with the square of the
/// distance ahead. It starts closed, dry and cohesive, so that the trigger only decides how many closed
/// segments lie ahead; the fracture energy is spent by the cohesion. From the end of a natural fracture,
/// which slides, stress and direction of the first segment are those of the greatest hoop stress
/// (hoop_direction.hpp). A natural fracture that is reached joins the fluid's network whole, with all that it
/// is connected to (joining_vertices.hpp).
/// @param time  coupling time [s]
/// @returns nothing if no tip advances
std::optional<GrowthPlan> plan_growth(const StructureModel& model, const Geometry& geometry,
                                      const StructureState& state, double time);

}  // namespace fissura::structure
