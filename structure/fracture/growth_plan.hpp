// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "common/fracture_network/fracture_network.hpp"
#include "structure/fracture/next_segment.hpp"
#include "structure/fracture/patch_plan.hpp"
#include "structure/structure_state.hpp"

namespace fissura::structure {

/// What grows at one coupling time: a patch for each tip that advances. Patches share no node.
struct GrowthPlan {
  std::vector<PatchPlan> patches;
  std::vector<FractureLine> new_lines;  ///< of fractures that grow for the first time
  Insertion insertion;                  ///< how the fluid's network changes
  double wall_seconds = 0;              ///< of planning
};

/// Early insertion of wet cohesive segments, for every tip at which
///   sigma_1(average over a half disc of 2 h) + p >= trigger f_t,tip ,
/// p the fluid pressure on the faces of the last open vertex, at least that of the pores. The segment is perpendicular to the greatest
/// principal stress of the average over 3 h, weighted with the square of the distance ahead. It starts closed, dry and cohesive, so that the trigger only decides how many closed
/// segments lie ahead; the fracture energy is spent by the cohesion.
/// @param time  coupling time [s]
/// @returns nothing if no tip advances
std::optional<GrowthPlan> plan_growth(const StructureModel& model, const Geometry& geometry, const StructureState& state,
                                      double time);

}  // namespace fissura::structure
