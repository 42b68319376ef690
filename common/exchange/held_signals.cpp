// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/held_signals.hpp"

#include <csignal>
#include <ctime>

namespace fissura {

namespace {

sigset_t held{};  // empty: all bits zero

}  // namespace

void hold_signals(std::initializer_list<int> signals) {
  sigemptyset(&held);
  for (const int signal : signals)
    if (!is_ignored(signal)) sigaddset(&held, signal);
  ::sigprocmask(SIG_BLOCK, &held, nullptr);
}

std::optional<int> held_signal() {
  const timespec at_once{};
  const int signal = ::sigtimedwait(&held, nullptr, &at_once);
  return signal > 0 ? std::optional(signal) : std::nullopt;
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace fissura
