// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/signals.hpp"

#include <sys/signalfd.h>
#include <unistd.h>

#include <cstdio>

namespace fissura::coupler {

namespace {

constexpr std::chrono::milliseconds one_press{250};

StatusPage* page_of_worker = nullptr;

bool is_ignored(int signal) {
  struct sigaction action {};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

extern "C" void ask_for_end(int signal) {
  page_of_worker->request_stop(signal);
}

}  // namespace

Signals::Signals() {
  sigemptyset(&set_);
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) sigaddset(&set_, signal);
  if (!is_ignored(SIGHUP)) sigaddset(&set_, SIGHUP);
  for (const int signal : {SIGPIPE, SIGTTOU}) std::signal(signal, SIG_IGN);
  ::sigprocmask(SIG_BLOCK, &set_, &previous_);
  descriptor_ = ::signalfd(-1, &set_, SFD_CLOEXEC | SFD_NONBLOCK);
}

Signals::~Signals() {
  ::close(descriptor_);
  ::sigprocmask(SIG_SETMASK, &previous_, nullptr);
}

void Signals::restore_in_child() const {
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
    std::fputs("coupler: a checkpoint is written at the next coupling time\n", stderr);
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
  std::fputs("coupler: stopping at the next coupling time (once more to stop at once)\n", stderr);
  status_.request_stop(signal);
}

void pass_stop_signals_to(StatusPage& status) {
  page_of_worker = &status;
  struct sigaction action {};
  action.sa_handler = ask_for_end;
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (!is_ignored(signal)) ::sigaction(signal, &action, nullptr);
}

}  // namespace fissura::coupler
