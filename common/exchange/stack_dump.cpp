// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/stack_dump.hpp"

#include <execinfo.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace fissura {

namespace {

std::atomic<bool> installed = false;

// Nothing here takes memory: whoever is stuck may be stuck in the allocator.
void dump(int) {
  const int errno_before = errno;
  constexpr const char* title = "stack, innermost call first:\n";
  (void)!::write(STDERR_FILENO, title, std::strlen(title));
  std::array<void*, 64> calls{};
  const int depth = ::backtrace(calls.data(), static_cast<int>(calls.size()));
  ::backtrace_symbols_fd(calls.data(), depth, STDERR_FILENO);
  errno = errno_before;
}

}  // namespace

void dump_stack_on_request() {
  // The first call loads a library, which is not to happen in the handler.
  std::array<void*, 1> warm_up{};
  (void)::backtrace(warm_up.data(), 1);
  struct sigaction action {};
  action.sa_handler = dump;
  action.sa_flags = SA_RESTART;
  ::sigaction(SIGUSR2, &action, nullptr);
  installed = true;
}

bool dumps_stack() {
  return installed;
}

}  // namespace fissura
