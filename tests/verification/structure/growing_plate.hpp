// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "structure/fracture/failing_tips.hpp"
#include "structure/fracture/growth.hpp"
#include "structure/structure_run.hpp"

namespace fissura::structure {

/// A square plate of shale, 1 m, that softens linearly, pulled apart slowly by its north and south side; its
/// tips grow along failure paths (TipRule::damage). It does what StructureSolver does, without messages.
class GrowingPlate {
 public:
  /// With a notch from `-notch` to `notch` [m] on y = 0, none if 0. `stretch` [m] is reached at end(),
  /// `fracture_energy` in J/m2.
  GrowingPlate(double h, double notch, double stretch, double fracture_energy, std::uint64_t seed);

  /// One coupling interval of ten steps, with the growth after it.
  void advance();

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] static double end() { return 0.06; }  ///< [s]
  [[nodiscard]] const Geometry& geometry() const { return geometry_; }
  [[nodiscard]] const StructureState& state() const { return state_; }
  [[nodiscard]] const std::vector<RemeshRecord>& records() const { return records_; }

  /// Spent on failure and cohesion so far [J/m].
  [[nodiscard]] double spent() const;
  /// Length of what grew or nucleated [m].
  [[nodiscard]] double inserted_length() const;
  /// Greatest distance of its vertices from y = 0 [m].
  [[nodiscard]] double deviation() const;

  /// Moment of all seismic sources, what moved without failing included, and what insertions brought [N m].
  [[nodiscard]] const PlaneTensor& told() const { return told_; }
  [[nodiscard]] const PlaneTensor& transferred() const { return state_.sources.transferred(); }

  /// Saves the state and restores it into this plate, as a new process would.
  void restart();

 private:
  void begin_run();

  StructureModel model_;
  Geometry geometry_;
  StructureState state_;
  FailingTips tips_;
  std::unique_ptr<StructureRun> run_;
  std::vector<Insertion> insertions_;
  std::vector<RemeshRecord> records_;
  PlaneTensor told_{};
  double time_ = 0;
};

}  // namespace fissura::structure
