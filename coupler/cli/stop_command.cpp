// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/stop_command.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "common/errors.hpp"
#include "coupler/cli/run_state.hpp"
#include "coupler/record/run_directory.hpp"

namespace fissura::coupler {

namespace {

constexpr useconds_t between_requests = 300'000;  // longer than what the supervisor takes for one press

/// The process that holds a run; its number cannot come to mean another process.
class Holder {
 public:
  explicit Holder(const std::filesystem::path& run_directory) : run_(run_directory) {
    const std::optional<long> pid = RunDirectory::holder(run_);
    if (pid) descriptor_ = static_cast<int>(::syscall(SYS_pidfd_open, static_cast<pid_t>(*pid), 0));
    // The run may have ended, and its number gone to another process, before the descriptor was opened.
    const bool holds_it = descriptor_ >= 0 && RunDirectory::holder(run_) == pid;
    if (!holds_it) not_running();
  }
  ~Holder() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Holder(const Holder&) = delete;
  Holder& operator=(const Holder&) = delete;

  void send(int signal) const {
    if (::syscall(SYS_pidfd_send_signal, descriptor_, signal, nullptr, 0) == 0 || errno == ESRCH) return;
    throw Error(ExitCode::precondition, fmt::format("the run in {} may not be stopped by this user: {}",
                                                    run_.string(), std::strerror(errno)));
  }

  [[nodiscard]] bool ends_within(double seconds) const {
    pollfd wait{descriptor_, POLLIN, 0};
    return ::poll(&wait, 1, static_cast<int>(1000 * seconds)) == 1;
  }

 private:
  [[noreturn]] void not_running() const {
    throw Error(ExitCode::precondition,
                fmt::format("the run in {} is not going on: coupler status {} says how it ended",
                            run_.string(), run_.string()));
  }

  std::filesystem::path run_;
  int descriptor_ = -1;
};

}  // namespace

int stop_command(const std::filesystem::path& run_directory, StopTime when, double patience) {
  const Holder holder(run_directory);
  holder.send(SIGTERM);
  if (when == StopTime::at_once) {
    ::usleep(between_requests);
    holder.send(SIGTERM);
  }
  if (!holder.ends_within(patience))
    throw Error(
        ExitCode::participant_unresponsive,
        fmt::format("the run in {0} has not ended within {1} s: coupler stop --now {0} ends it at once",
                    run_directory.string(), patience));
  const RunState state = read_run_state(run_directory);
  if (!state.report.is_object())
    throw Error(ExitCode::participant_died,
                fmt::format("the run in {} ended and left no report", run_directory.string()));
  std::printf("%s\n", state.report.value("last_line", "the run was complete before that").c_str());
  const int code = state.report.value("code", 0);
  const bool as_asked = code <= 1 || code > 128;
  return as_asked ? 0 : code;
}

}  // namespace fissura::coupler
