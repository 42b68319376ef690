// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/worker_watch.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <cmath>
#include <csignal>
#include <cstring>

#include "coupler/launch/memory_kills.hpp"
#include "coupler/launch/tell.hpp"

namespace fissura::coupler {

namespace {

constexpr std::chrono::milliseconds tick{50};
constexpr std::chrono::milliseconds own_pause{
    500};                               // longer than that between two looks: this process did not run
constexpr double stop_tolerance = 1.5;  // wall seconds a worker may be stopped
constexpr double closing_time = 4.0;    // wall seconds to close a run that has failed
constexpr double warning_part = 0.5;    // of the deadline

double since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

WorkerWatch::WorkerWatch(StatusPage& status, double deadline, Requests& requests, ChildProcess& worker)
    : status_(status),
      deadline_(deadline),
      requests_(requests),
      worker_(worker),
      memory_kills_before_(memory_kills()),
      beats_(status.beats()) {}

WorkerEnd WorkerWatch::until_end() {
  for (;;) {
    pollfd waits[] = {{worker_.descriptor(), POLLIN, 0}, {requests_.signals().descriptor(), POLLIN, 0}};
    ::poll(waits, 2, static_cast<int>(tick.count()));
    discount_own_pause();
    if (const std::optional<ProcessEnd> end = worker_.end()) return ended_by_itself(*end);
    requests_.hear();
    if (const std::optional<WorkerEnd> end = reason_to_end()) {
      worker_.wait_or_kill(0);
      return *end;
    }
  }
}

std::optional<WorkerEnd> WorkerWatch::reason_to_end() {
  if (requests_.end_at_once() != 0)
    return asked_for(requests_.end_at_once(), status_.phase().c_str(),
                     fmt::format("ended at once by signal {} ({}), as asked", requests_.end_at_once(),
                                 ::strsignal(requests_.end_at_once())));
  if (is_stopped())
    return finding(ExitCode::participant_unresponsive, "the coupler's worker is stopped by a signal");
  if (is_stuck())
    return finding(ExitCode::participant_unresponsive,
                   fmt::format("the coupler's worker is alive but made no progress for {} s", deadline_));
  if (is_slow_to_close())
    return finding(ExitCode::participant_unresponsive, "the coupler's worker does not end");
  return std::nullopt;
}

WorkerEnd WorkerWatch::ended_by_itself(const ProcessEnd& end) const {
  const bool concluded = status_.conclusion() && !end.signal;
  if (!concluded) {
    const std::optional<std::uint64_t> kills = memory_kills();
    const bool out_of_memory =
        end.signal == SIGKILL && kills && memory_kills_before_ && *kills > *memory_kills_before_;
    return finding(
        out_of_memory ? ExitCode::out_of_memory : ExitCode::participant_died,
        "the coupler's worker " + end.sentence() + (out_of_memory ? " by the kernel: out of memory" : ""));
  }
  const RunFailure failure = status_.failure();
  if (failure.exit_code != 0) return {failure.exit_code, failure};
  if (*status_.conclusion() > 128)
    return asked_for(*status_.conclusion() - 128, "stopped", "ended at a coupling time, as asked");
  return {*status_.conclusion(), {}};
}

WorkerEnd WorkerWatch::finding(ExitCode code, const std::string& sentence) const {
  RunFailure failure = status_.failure();
  if (failure.exit_code == 0) {
    const RunStatus status = status_.read();
    failure.exit_code = static_cast<int>(code);
    failure.who = "coupler";
    failure.interval = status.interval;
    failure.phase = status.phase;
    failure.sentence = sentence;
  }
  return {failure.exit_code, failure};
}

WorkerEnd WorkerWatch::asked_for(int signal, const char* phase, const std::string& sentence) const {
  RunFailure failure;
  failure.exit_code = 128 + signal;
  failure.who = "coupler";
  failure.interval = status_.interval();
  failure.phase = phase;
  failure.sentence = sentence;
  return {failure.exit_code, failure};
}

void WorkerWatch::discount_own_pause() {
  const Clock::time_point now = Clock::now();
  const Clock::duration pause = now - last_look_;
  last_look_ = now;
  if (pause < own_pause) return;
  last_beat_ += pause;
  if (stopped_since_) *stopped_since_ += pause;
  if (failed_since_) *failed_since_ += pause;
}

bool WorkerWatch::is_stopped() {
  if (!worker_.stopped())
    stopped_since_.reset();
  else if (!stopped_since_)
    stopped_since_ = last_look_;
  return stopped_since_ && since(*stopped_since_) > stop_tolerance && std::isfinite(deadline_);
}

bool WorkerWatch::is_stuck() {
  if (status_.beats() != beats_) {
    beats_ = status_.beats();
    last_beat_ = last_look_;
    warned_ = false;
  }
  if (!warned_ && since(last_beat_) > warning_part * deadline_) {
    warned_ = true;
    tell(fmt::format("coupler: warning: the worker has made no progress for {} s (interval {}, phase {})",
                     warning_part * deadline_, status_.interval(), status_.phase()));
    worker_.send_signal(SIGUSR2);  // it prints where it is
  }
  return since(last_beat_) > deadline_;
}

bool WorkerWatch::is_slow_to_close() {
  if (status_.failure().exit_code == 0) return false;
  if (!failed_since_) failed_since_ = last_look_;
  return since(*failed_since_) > closing_time;
}

}  // namespace fissura::coupler
