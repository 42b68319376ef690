// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/progress_ladder.hpp"

#include <array>

namespace fissura::coupler {

namespace {

struct Step {
  Rung rung;
  double part;  ///< of the deadline
};
constexpr std::array<Step, 3> ladder{{{Rung::warning, 0.1}, {Rung::diagnosis, 0.3}, {Rung::end, 1.0}}};

}  // namespace

std::optional<Rung> ProgressLadder::climb(double silent_seconds) {
  if (silent_seconds < silence_) climbed_ = 0;
  silence_ = silent_seconds;
  if (climbed_ == ladder.size()) return std::nullopt;
  const Step& next = ladder[climbed_];
  if (silent_seconds <= next.part * deadline_) return std::nullopt;
  ++climbed_;
  return next.rung;
}

}  // namespace fissura::coupler
