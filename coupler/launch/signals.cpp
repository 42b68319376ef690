// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/signals.hpp"

#include <sys/signalfd.h>
#include <unistd.h>

#include "common/exchange/held_signals.hpp"
#include "coupler/launch/tell.hpp"

namespace fissura::coupler {

namespace {

constexpr std::chrono::milliseconds one_press{250};

}  // namespace

Signals::Signals() {
  sigemptyset(&set_);
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) sigaddset(&set_, signal);
  if (!is_ignored(SIGHUP)) sigaddset(&set_, SIGHUP);
  for (const int signal : {SIGPIPE, SIGTTOU, SIGXFSZ}) std::signal(signal, SIG_IGN);
  ::sigprocmask(SIG_BLOCK, &set_, &previous_);
  descriptor_ = ::signalfd(-1, &set_, SFD_CLOEXEC | SFD_NONBLOCK);
}

Signals::~Signals() {
  ::close(descriptor_);
  ::sigprocmask(SIG_SETMASK, &previous_, nullptr);
}

std::optional<int> Signals::next() {
  signalfd_siginfo information{};
  if (::read(descriptor_, &information, sizeof(information)) != sizeof(information)) return std::nullopt;
  return static_cast<int>(information.ssi_signo);
}

void Requests::hear() {
  while (const std::optional<int> signal = signals_.next()) {
    if (*signal != SIGUSR1) {
      hear_stop(*signal);
      continue;
    }
    tell("coupler: a checkpoint is written at the next coupling time");
    status_.request_checkpoint();
  }
}

void Requests::hear_stop(int signal) {
  const Clock::time_point now = Clock::now();
  const bool same_press = asked_ && now - last_ < one_press;
  last_ = now;
  if (same_press) return;
  if (asked_) {
    end_at_once_ = signal;
    return;
  }
  asked_ = true;
  tell("coupler: stopping at the next coupling time (once more to stop at once)");
  status_.request_stop(signal);
}

void hold_signals_of_worker() {
  hold_signals({SIGINT, SIGTERM, SIGHUP, SIGUSR1});
}

void pass_on_signals(StatusPage& status) {
  while (const std::optional<int> signal = held_signal()) {
    if (*signal == SIGUSR1)
      status.request_checkpoint();
    else
      status.request_stop(*signal);
  }
}

}  // namespace fissura::coupler
