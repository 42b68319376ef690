// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/apart.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>

#include "common/errors.hpp"

namespace fissura::coupler {

namespace {

constexpr unsigned patience = 60;

[[noreturn]] void look_and_end(const std::function<std::string()>& look, int answer) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGALRM}) std::signal(signal, SIG_DFL);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  ::alarm(patience);
  int code = 1;
  try {
    const std::string text = look();
    code = ::write(answer, text.data(), text.size()) == static_cast<ssize_t>(text.size()) ? 0 : 1;
  } catch (...) {
  }
  ::_exit(code);
}

}  // namespace

std::optional<std::string> look_apart(const std::function<std::string()>& look) {
  std::fflush(nullptr);
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw StorageError("cannot open a pipe");
  const pid_t child = ::fork();
  if (child == 0) look_and_end(look, ends[1]);
  ::close(ends[1]);
  std::string text;
  std::array<char, 4096> block{};
  for (;;) {
    const ssize_t count = ::read(ends[0], block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    text.append(block.data(), static_cast<std::size_t>(count));
  }
  ::close(ends[0]);
  int status = 0;
  while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (child < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
  return text;
}

}  // namespace fissura::coupler
