// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace fissura::coupler {

namespace {

constexpr std::chrono::milliseconds terminal_interval{200};
constexpr std::chrono::milliseconds plain_interval{5000};

}  // namespace

ProgressLine::ProgressLine(double end_time)
    : end_time_(end_time), terminal_(::isatty(STDERR_FILENO) != 0), next_(start_ + terminal_interval) {}

ProgressLine::~ProgressLine() {
  if (terminal_ && written_) std::fputc('\n', stderr);
}

void ProgressLine::show(const IntervalRecord& record) {
  const Clock::time_point now = Clock::now();
  if (!start_time_) start_time_ = record.time - record.duration;
  if (now < next_) return;
  next_ = now + (terminal_ ? terminal_interval : plain_interval);
  const double wall = std::chrono::duration<double>(now - start_).count();
  const double left = wall * (end_time_ - record.time) / (record.time - *start_time_);
  const std::string line = fmt::format(
      "t {:.4g} of {:.4g} s   half length {:.2f} m   aperture {:.4f} mm   net pressure {:.4f} MPa   {:.0f} s "
      "left",
      record.time, end_time_, record.half_length, 1e3 * record.inlet_aperture,
      1e-6 * record.inlet_net_pressure, left);
  std::fprintf(stderr, terminal_ ? "\r%s\033[K" : "%s\n", line.c_str());
  std::fflush(stderr);
  written_ = true;
}

}  // namespace fissura::coupler
