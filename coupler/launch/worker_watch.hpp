// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "common/errors.hpp"
#include "coupler/launch/child_process.hpp"
#include "coupler/launch/signals.hpp"
#include "coupler/launch/status_page.hpp"

namespace fissura::coupler {

/// How one life of the worker ended.
struct WorkerEnd {
  int exit_code = 0;   ///< for the whole run, if it does not go on
  RunFailure failure;  ///< its exit_code is 0 if the run is complete
};

/// Watches the worker until it has ended, or must be: when it is stopped by a signal, makes no progress,
/// takes too long to close a run that has failed, or when the user wants the end at once. What the worker
/// itself reported first goes before what became of it then. Time in which this process did not run itself (a
/// machine asleep) does not count.
class WorkerWatch {
 public:
  /// @param deadline  wall seconds the worker may go without a beat
  WorkerWatch(StatusPage& status, double deadline, Requests& requests, ChildProcess& worker);

  /// The worker has ended afterwards; its children may not have.
  WorkerEnd until_end();

 private:
  using Clock = std::chrono::steady_clock;

  /// The reason to end the worker, if there is one.
  std::optional<WorkerEnd> reason_to_end();
  [[nodiscard]] WorkerEnd ended_by_itself(const ProcessEnd& end) const;
  [[nodiscard]] WorkerEnd finding(ExitCode code, const std::string& sentence) const;
  [[nodiscard]] WorkerEnd asked_for(int signal, const char* phase, const std::string& sentence) const;
  void discount_own_pause();
  bool is_stopped();
  bool is_stuck();
  bool is_slow_to_close();

  StatusPage& status_;
  double deadline_;
  Requests& requests_;
  ChildProcess& worker_;
  std::optional<std::uint64_t> memory_kills_before_;
  std::uint64_t beats_ = 0;
  bool warned_ = false;
  Clock::time_point last_look_ = Clock::now(), last_beat_ = last_look_;
  std::optional<Clock::time_point> stopped_since_, failed_since_;
};

}  // namespace fissura::coupler
