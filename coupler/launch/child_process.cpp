// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <utility>

#include "common/errors.hpp"

namespace fissura::coupler {

namespace {

int open_pidfd(pid_t pid) { return static_cast<int>(::syscall(SYS_pidfd_open, pid, 0)); }

/// In the child: never returns; an execution error goes up the pipe.
[[noreturn]] void execute(const std::vector<std::string>& command, int error_pipe) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);  // this process holds its own signals back
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  ::execvp(words[0], words.data());
  const int reason = errno;
  (void)!::write(error_pipe, &reason, sizeof(reason));
  ::_exit(127);
}

}  // namespace

std::string ProcessEnd::sentence() const {
  if (signal)
    return fmt::format("was killed by signal {} (SIG{}, {})", *signal, ::sigabbrev_np(*signal), ::strsignal(*signal));
  if (exit_code == 0) return "ended early with the exit code of success";
  return fmt::format("ended with exit code {} ({})", exit_code,
                     exit_code == 127 ? "command not found" : name(static_cast<ExitCode>(exit_code)));
}

ChildProcess::ChildProcess(const std::vector<std::string>& command) {
  int error_pipe[2];
  if (::pipe2(error_pipe, O_CLOEXEC) != 0) throw Error(ExitCode::precondition, "cannot open a pipe");
  pid_ = ::fork();
  if (pid_ < 0) throw Error(ExitCode::precondition, fmt::format("cannot start {}: {}", command[0], ::strerror(errno)));
  if (pid_ == 0) execute(command, error_pipe[1]);
  ::close(error_pipe[1]);
  int reason = 0;
  const bool failed = ::read(error_pipe[0], &reason, sizeof(reason)) == sizeof(reason);
  ::close(error_pipe[0]);
  if (failed) {
    ::waitpid(pid_, nullptr, 0);
    throw Error(ExitCode::precondition, fmt::format("cannot start {}: {}", command[0], ::strerror(reason)));
  }
  pidfd_ = open_pidfd(pid_);
}

ChildProcess::ChildProcess(pid_t child) : pid_(child), pidfd_(open_pidfd(child)) {}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      pidfd_(std::exchange(other.pidfd_, -1)),
      stopped_(other.stopped_),
      end_(other.end_) {}

ChildProcess::~ChildProcess() {
  if (pid_ > 0 && !end_) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  if (pidfd_ >= 0) ::close(pidfd_);
}

std::optional<ProcessEnd> ChildProcess::end() {
  if (end_) return end_;
  int status = 0;
  while (::waitpid(pid_, &status, WNOHANG | WUNTRACED | WCONTINUED) == pid_) {
    if (WIFSTOPPED(status)) stopped_ = true;
    if (WIFCONTINUED(status)) stopped_ = false;
    if (WIFEXITED(status)) end_ = ProcessEnd{WEXITSTATUS(status), std::nullopt};
    if (WIFSIGNALED(status)) end_ = ProcessEnd{0, WTERMSIG(status)};
    if (end_) break;
  }
  return end_;
}

bool ChildProcess::stopped() { return !end() && stopped_; }

void ChildProcess::send_signal(int signal) {
  if (!end()) ::kill(pid_, signal);
}

bool ChildProcess::wait(double seconds) {
  if (end()) return true;
  pollfd wait{pidfd_, POLLIN, 0};
  ::poll(&wait, 1, static_cast<int>(seconds * 1000));
  return end().has_value();
}

ProcessEnd ChildProcess::wait_or_kill(double seconds) {
  if (!wait(seconds)) {
    ::kill(pid_, SIGKILL);
    while (!wait(1.0)) {
    }
  }
  return *end_;
}

}  // namespace fissura::coupler
