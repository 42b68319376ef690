// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <csignal>
#include <optional>

#include "coupler/launch/status_page.hpp"

namespace fissura::coupler {

/// The signals by which a user asks something of a run, read from a descriptor instead of handled: SIGINT,
/// SIGTERM, SIGHUP (unless it was ignored when the program started, as under nohup) and SIGUSR1. SIGPIPE,
/// SIGTTOU and SIGXFSZ are ignored: a log that nobody reads any more, or a terminal that wants no output from
/// the background, does not end a run, and a file beyond its limit is a failed write.
class Signals {
 public:
  Signals();
  ~Signals();
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  /// Readable when a signal has come.
  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// The next signal that has come.
  std::optional<int> next();

 private:
  sigset_t set_{}, previous_{};
  int descriptor_ = -1;
};

/// What the user has asked of a run. A first SIGINT, SIGTERM or SIGHUP asks for its end at the next coupling
/// time, a second one for its end at once; signals closer together than a finger can press count as one.
/// SIGUSR1 asks for a checkpoint.
class Requests {
 public:
  explicit Requests(StatusPage& status) : status_(status) {}

  [[nodiscard]] const Signals& signals() const { return signals_; }
  /// Takes every signal that has come and passes it on to the worker. Answers with a line on standard error.
  void hear();
  /// The signal that asked for the end at once, or 0.
  [[nodiscard]] int end_at_once() const { return end_at_once_; }
  /// The signal that asked for the end at a coupling time, whoever got it, or 0.
  [[nodiscard]] int end_asked() const { return status_.stop_signal(); }

 private:
  using Clock = std::chrono::steady_clock;
  void hear_stop(int signal);

  StatusPage& status_;
  Signals signals_;
  bool asked_ = false;
  int end_at_once_ = 0;
  Clock::time_point last_{};
};

/// In the worker, before anything else: its own signals (from a service manager that signals every process of
/// a run) wait for pass_on_signals.
void hold_signals_of_worker();

/// In the worker, now and then: its own signals ask for what they would ask of the supervisor.
void pass_on_signals(StatusPage& status);

}  // namespace fissura::coupler
