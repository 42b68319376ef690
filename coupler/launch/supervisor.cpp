// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/supervisor.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <optional>

#include "common/errors.hpp"
#include "coupler/launch/child_process.hpp"

namespace fissura::coupler {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int tick_ms = 50;
constexpr double stop_tolerance = 1.5;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// SIGINT, SIGTERM and SIGHUP as a file descriptor instead of handlers.
class Signals {
 public:
  Signals() {
    sigemptyset(&set_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&set_, signal);
    ::sigprocmask(SIG_BLOCK, &set_, &previous_);
    descriptor_ = ::signalfd(-1, &set_, SFD_CLOEXEC | SFD_NONBLOCK);
  }
  ~Signals() {
    ::close(descriptor_);
    ::sigprocmask(SIG_SETMASK, &previous_, nullptr);
  }
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;
  void restore_in_child() { ::sigprocmask(SIG_SETMASK, &previous_, nullptr); }
  [[nodiscard]] int descriptor() const { return descriptor_; }
  std::optional<int> next() {
    signalfd_siginfo info{};
    if (::read(descriptor_, &info, sizeof(info)) != sizeof(info)) return std::nullopt;
    return static_cast<int>(info.ssi_signo);
  }

 private:
  sigset_t set_{}, previous_{};
  int descriptor_ = -1;
};

/// Ends whatever is left of the worker's process group, and reaps it.
void end_group(pid_t leader) {
  ::kill(-leader, SIGKILL);
  for (int wait = 0; wait < 200; ++wait) {
    while (::waitpid(-1, nullptr, WNOHANG) > 0) {
    }
    if (::kill(-leader, 0) != 0) return;
    ::usleep(5000);
  }
}

class Watch {
 public:
  Watch(StatusPage& status, double deadline, ChildProcess& worker)
      : status_(status), deadline_(deadline), worker_(worker) {}

  int run(Signals& signals) {
    for (;;) {
      pollfd waits[] = {{worker_.descriptor(), POLLIN, 0}, {signals.descriptor(), POLLIN, 0}};
      ::poll(waits, 2, tick_ms);
      if (const std::optional<ProcessEnd> end = worker_.end()) return worker_ended(*end);
      while (const std::optional<int> signal = signals.next()) {
        if (status_.stop_signal() != 0) return 128 + *signal;
        std::fprintf(stderr, "coupler: stopping at the next coupling time (once more to stop at once)\n");
        status_.request_stop(*signal);
      }
      if (is_stopped()) return ended(ExitCode::participant_unresponsive, "is stopped by a signal");
      if (is_stuck())
        return ended(ExitCode::participant_unresponsive,
                     fmt::format("is alive but made no progress for {} s", deadline_));
    }
  }

 private:
  int worker_ended(const ProcessEnd& end) {
    if (!end.signal) return end.exit_code;
    return ended(ExitCode::participant_died, end.sentence());
  }

  bool is_stopped() {
    if (!worker_.stopped()) stopped_since_.reset();
    else if (!stopped_since_) stopped_since_ = Clock::now();
    return stopped_since_ && since(*stopped_since_) > stop_tolerance;
  }

  bool is_stuck() {
    if (status_.beats() != beats_) {
      beats_ = status_.beats();
      last_beat_ = Clock::now();
    }
    return since(last_beat_) > deadline_;
  }

  int ended(ExitCode code, const std::string& cause) {
    print_last_line(static_cast<int>(code), "coupler", status_.interval(), status_.phase().c_str(),
                    ("the coupler's worker " + cause).c_str());
    return static_cast<int>(code);
  }

  StatusPage& status_;
  double deadline_;
  ChildProcess& worker_;
  std::uint64_t beats_ = 0;
  Clock::time_point last_beat_ = Clock::now();
  std::optional<Clock::time_point> stopped_since_;
};

}  // namespace

int supervise(StatusPage& status, const Supervision& supervision,
              const std::function<int(const Attempt&)>& work) {
  // Participants of a dead worker become children of this process, so that they can be ended and reaped.
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  Signals signals;
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child < 0) throw Error(ExitCode::precondition, "cannot fork the worker");
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::setpgid(0, 0);
    signals.restore_in_child();
    std::signal(SIGPIPE, SIG_IGN);
    const int code = work(supervision.first);
    std::fflush(nullptr);
    ::_exit(code);
  }
  ::setpgid(child, child);
  int code = 0;
  {
    ChildProcess worker(child);
    code = Watch(status, supervision.deadline, worker).run(signals);
    end_group(child);
  }
  return code;
}

void print_last_line(int exit_code, const char* who, std::uint64_t interval, const char* phase, const char* sentence) {
  std::fprintf(stderr, "coupler: %s %s interval=%llu phase=%s: %s\n", name(static_cast<ExitCode>(exit_code)), who,
               static_cast<unsigned long long>(interval), phase, sentence);
}

}  // namespace fissura::coupler
