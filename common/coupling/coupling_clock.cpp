// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/coupling/coupling_clock.hpp"

#include <algorithm>

#include "common/errors.hpp"

namespace fissura {

CouplingClock::CouplingClock(double end) : end_(end) {
  ENSURE(end > 0);
}

ClockInterval CouplingClock::next(double proposed, double must_hit) const {
  const double limit = std::min(must_hit, end_);
  ENSURE(proposed > 0 && limit > time_);
  const double remaining = limit - time_;
  double end = time_ + proposed;
  if (proposed >= remaining)
    end = limit;
  else if (remaining < 1.1 * proposed)
    end = time_ + remaining / 2;
  return {index_ + 1, time_, end};
}

void CouplingClock::commit(const ClockInterval& interval) {
  ENSURE(interval.index == index_ + 1 && interval.begin == time_ && interval.end > time_);
  index_ = interval.index;
  time_ = interval.end;
}

void CouplingClock::resume(std::uint64_t index, double time) {
  if (!(time >= 0 && time <= end_))
    throw Error(ExitCode::checkpoint_unusable, "the saved time lies outside the run");
  index_ = index;
  time_ = time;
}

}  // namespace fissura
