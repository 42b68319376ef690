// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace fissura {

/// One coupling interval (begin, end].
struct ClockInterval {
  std::uint64_t index = 0;  ///< 1 for the first
  double begin = 0;         ///< t_c1 [s]
  double end = 0;           ///< t_c2 [s]

  [[nodiscard]] double duration() const { return end - begin; }
};

/// Coupling times. The current time is always one of the stored times, never a sum of steps; times that must
/// be hit (end of the run, pump events, reports) are hit exactly.
class CouplingClock {
 public:
  /// @param end  end of the run [s], > 0
  explicit CouplingClock(double end);

  /// The next interval, of `proposed` length [s] or shorter so that it ends at `must_hit` [s] at the latest.
  /// An interval that would leave less than a tenth of `proposed` before `must_hit` is halved instead. @pre
  /// proposed > 0, must_hit > time()
  [[nodiscard]] ClockInterval next(double proposed, double must_hit) const;

  /// Makes the end of `interval` the current time. @pre interval came from next()
  void commit(const ClockInterval& interval);

  /// Makes `time` [s], the end of interval `index`, the current time: of a run that goes on from a
  /// checkpoint. Throws Error(checkpoint_unusable) if it lies outside [0, end].
  void resume(std::uint64_t index, double time);

  [[nodiscard]] double time() const { return time_; }           ///< [s]
  [[nodiscard]] std::uint64_t index() const { return index_; }  ///< of the last committed interval
  [[nodiscard]] bool finished() const { return time_ >= end_; }
  [[nodiscard]] double end() const { return end_; }  ///< [s]

 private:
  double end_;
  double time_ = 0;
  std::uint64_t index_ = 0;
};

}  // namespace fissura
