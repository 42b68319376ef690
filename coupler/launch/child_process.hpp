// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace fissura::coupler {

/// How a process ended, in words: "was killed by signal 9 (Killed)", "ended with exit code 3", ...
struct ProcessEnd {
  int exit_code = 0;              ///< if it ended by itself
  std::optional<int> signal;      ///< if a signal ended it

  [[nodiscard]] std::string sentence() const;
};

/// A child of this process. It dies with its parent. Destroying the object kills and reaps the child.
class ChildProcess {
 public:
  /// Starts `command` (words, searched in PATH) in the process group of the caller. Throws Error(precondition) naming the program and
  /// the reason if it cannot be executed.
  explicit ChildProcess(const std::vector<std::string>& command);
  /// Watches a child that was forked elsewhere.
  explicit ChildProcess(pid_t child);
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ChildProcess(const ChildProcess&) = delete;

  [[nodiscard]] pid_t pid() const { return pid_; }
  /// Readable once the process has ended.
  [[nodiscard]] int descriptor() const { return pidfd_; }

  /// Reaps the process if it has ended.
  std::optional<ProcessEnd> end();
  /// True while a stop signal holds the process.
  bool stopped();
  /// Sends `signal`; nothing if the process has ended.
  void send_signal(int signal);
  /// Waits at most `seconds` for the end. @returns whether it has ended
  bool wait(double seconds);
  /// The same, and kills it then. @returns how it ended
  ProcessEnd wait_or_kill(double seconds);

 private:
  pid_t pid_ = -1;
  int pidfd_ = -1;
  bool stopped_ = false;
  std::optional<ProcessEnd> end_;
};

}  // namespace fissura::coupler
