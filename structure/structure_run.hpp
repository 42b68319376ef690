// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "structure/dynamics/central_difference.hpp"
#include "structure/joints/joint_step.hpp"
#include "structure/structure_state.hpp"

namespace fissura::structure {

/// Wall time of the explicit loops [s].
struct LoopTimes {
  double elements = 0;  ///< element loop with the nodes it integrates
  double joints = 0;    ///< joint loop with its nodes
};

/// The structure over one coupling interval in equal explicit steps: THE LOOP of this process.
class StructureRun {
 public:
  /// `model` and `geometry` must outlive this; build it anew when the geometry changed.
  StructureRun(const StructureModel& model, const Geometry& geometry);

  /// Advances `state` from `begin` to `end` [s] under the pressure ramps set in its joints.
  /// @returns number of explicit steps
  /// Throws SolverError if the motion is no longer finite, or faces have slid so far that they no longer face each other.
  std::uint64_t advance(double begin, double end, StructureState& state);

  /// At the end of the last advance, with the scaled mass, per unit thickness [J/m].
  [[nodiscard]] double kinetic_energy() const { return kinetic_energy_; }

  [[nodiscard]] const LoopTimes& loop_times() const { return loop_times_; }

 private:
  const StructureModel& model_;
  const Geometry& geometry_;
  CentralDifference dynamics_;
  JointStep joints_;
  std::vector<double> sliding_limits_;  ///< of every unit [m]
  LoopTimes loop_times_;
  double kinetic_energy_ = 0;
};

/// At a coupling time [s]: follows the pumping with the mass scale.
void scale_masses(const StructureModel& model, const Geometry& geometry, double begin, double end,
                  StructureState& state);

/// Work spent on damage and plastic flow so far, per unit thickness [J/m]: of the elements there are, and what insertions took out of
/// others; 0 without bulk failure.
double failure_work(const StructureModel& model, const Geometry& geometry, const StructureState& state);

}  // namespace fissura::structure
