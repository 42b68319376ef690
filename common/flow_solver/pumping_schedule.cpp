// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/flow_solver/pumping_schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/errors.hpp"

namespace fissura {

double target_at(const PumpingStage& stage, const StageEntry& entry, double time) {
  const double start = stage.control == WellControl::rate ? entry.rate : entry.pressure;
  const double elapsed = time - stage.begin;
  if (elapsed >= stage.ramp) return stage.target;
  return start + (stage.target - start) * (elapsed / stage.ramp);
}

double mean_target(const PumpingStage& stage, const StageEntry& entry, double begin, double end) {
  const double ramp_end = std::clamp(stage.begin + stage.ramp, begin, end);
  const double ramped =
      0.5 * (target_at(stage, entry, begin) + target_at(stage, entry, ramp_end)) * (ramp_end - begin);
  if (ramp_end == begin) return stage.target;
  return (ramped + stage.target * (end - ramp_end)) / (end - begin);
}

Schedule::Schedule(std::vector<PumpingStage> stages) : stages_(std::move(stages)) {
  for (std::size_t k = 0; k < stages_.size(); ++k) {
    if (stages_[k].ramp < 0)
      throw InputError(
          fmt::format("pumping stage {} has a ramp of {} s, expected at least 0", k, stages_[k].ramp));
    if (k > 0 && stages_[k].begin <= stages_[k - 1].begin)
      throw InputError(fmt::format("pumping stage {} begins at {} s, expected later than stage {} at {} s", k,
                                   stages_[k].begin, k - 1, stages_[k - 1].begin));
  }
}

std::optional<std::size_t> Schedule::stage_from(double time) const {
  const auto after = std::upper_bound(stages_.begin(), stages_.end(), time,
                                      [](double t, const PumpingStage& stage) { return t < stage.begin; });
  if (after == stages_.begin()) return std::nullopt;
  return static_cast<std::size_t>(after - stages_.begin()) - 1;
}

std::optional<double> Schedule::next_change(double time) const {
  const auto after = std::upper_bound(stages_.begin(), stages_.end(), time,
                                      [](double t, const PumpingStage& stage) { return t < stage.begin; });
  if (after == stages_.end()) return std::nullopt;
  return after->begin;
}

}  // namespace fissura
