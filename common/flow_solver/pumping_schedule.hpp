// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "common/flow_solver/flow_case.hpp"

namespace fissura {

/// What the well did when a stage began: where its ramp starts.
struct StageEntry {
  double rate = 0;      ///< [m2/s]
  double pressure = 0;  ///< [Pa]
};

/// Target of `stage` at `time` [m2/s] or [Pa]: the entry's value at begin, then linear, then constant from
/// begin + ramp on.
double target_at(const PumpingStage& stage, const StageEntry& entry, double time);

/// Mean of target_at over [begin, end], exact for the piecewise linear target. @pre end > begin >=
/// stage.begin
double mean_target(const PumpingStage& stage, const StageEntry& entry, double begin, double end);

/// The stages in the order of their begins. Before the first the well is shut in.
class Schedule {
 public:
  Schedule() = default;
  /// Throws InputError if the begins do not increase or a ramp is negative.
  explicit Schedule(std::vector<PumpingStage> stages);

  [[nodiscard]] const std::vector<PumpingStage>& stages() const { return stages_; }

  /// The stage in force in an interval that begins at `time` [s]; none before the first.
  [[nodiscard]] std::optional<std::size_t> stage_from(double time) const;

  /// The first begin of a stage after `time` [s]; none after the last.
  [[nodiscard]] std::optional<double> next_change(double time) const;

 private:
  std::vector<PumpingStage> stages_;
};

}  // namespace fissura
