// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/progress.hpp"

#include <chrono>

#include "common/exchange/participant.hpp"

namespace fissura {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds report_interval{100};

ProgressReport installed_report;
Clock::time_point next_report{};
unsigned long count = 0;
const char* phase_of_last_note = "start";

}  // namespace

void set_progress_report(ProgressReport report) {
  installed_report = std::move(report);
  next_report = {};
}

const char* last_phase() { return phase_of_last_note; }

void set_phase(const char* phase) { phase_of_last_note = phase; }

void note_progress(const char* phase) {
  ++count;
  phase_of_last_note = phase;
  if (!installed_report) return;
  const Clock::time_point now = Clock::now();
  if (now < next_report) return;
  next_report = now + report_interval;
  installed_report(phase, count);
}

}  // namespace fissura
