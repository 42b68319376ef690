// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "structure/fracture/growth_plan.hpp"

namespace fissura::structure {

/// One inserted segment in the remesh ledger. Energies, errors and hashes are those of everything inserted at the same coupling time.
struct RemeshRecord {
  std::string fracture;                 ///< name of its line
  Point tip{};                          ///< end of the segment [m]
  std::size_t removed = 0, made = 0;    ///< elements of this patch
  std::size_t untouched = 0;            ///< elements outside all patches whose nodes are the same as before
  std::string hash_before, hash_after;  ///< of the untouched elements and of every node that was there before and is still used
  double smallest_angle = 0;            ///< of the elements made [rad]
  double smallest_altitude = 0;         ///< [m]
  double stable_step_before = 0, stable_step_after = 0;        ///< [s]
  double strain_energy_before = 0, strain_energy_after = 0;    ///< left in the patches after failure, whole thickness [J]
  double kinetic_energy_before = 0, kinetic_energy_after = 0;  ///< of their nodes [J]
  double mass_error = 0, momentum_error = 0;                   ///< [-], see TransferBalance
  double wall_seconds = 0;                                     ///< of planning and carrying out, shared out among the segments
};

/// What a plan will remove, divide or give other faces.
EntitiesThatChange entities_that_change(const GrowthPlan& plan);

/// Carries out a plan: mesh, everything derived from it, joints and state. The network is left to the caller.
std::vector<RemeshRecord> grow(const GrowthPlan& plan, const StructureModel& model, Geometry& geometry,
                               StructureState& state);

/// Elements in which no bulk damage may start (BulkFailure::tip_exclusion): those near a tip that grows by inserted segments, and those
/// near faces that still have cohesion, which otherwise would have to fail twice. Ascending.
std::vector<ElementIndex> tip_surroundings(const StructureModel& model, const Geometry& geometry, const Joints& joints);

/// For the ACKNOWLEDGE of an INSERT (docs/protocol.md).
nlohmann::json remeshing_json(const std::vector<RemeshRecord>& records);

}  // namespace fissura::structure
