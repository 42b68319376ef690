// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>

#include "coupler/record/interval_record.hpp"

namespace fissura::coupler {

/// How the run gets on, on standard error: one line that rewrites itself on a terminal, a plain line every
/// few seconds otherwise.
class ProgressLine {
 public:
  explicit ProgressLine(double end_time);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const IntervalRecord& record);

 private:
  using Clock = std::chrono::steady_clock;
  double end_time_;
  bool terminal_;
  bool written_ = false;
  Clock::time_point start_ = Clock::now(), next_;
  std::optional<double> start_time_;  ///< simulated, at which this process took the run up [s]
};

}  // namespace fissura::coupler
