// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/supervisor.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <set>

#include "common/errors.hpp"
#include "common/exchange/stack_dump.hpp"
#include "coupler/launch/child_process.hpp"
#include "coupler/launch/last_line.hpp"
#include "coupler/launch/process_tree.hpp"
#include "coupler/launch/run_report.hpp"
#include "coupler/launch/signals.hpp"
#include "coupler/launch/tell.hpp"
#include "coupler/launch/worker_watch.hpp"
#include "coupler/record/checked_file.hpp"

namespace fissura::coupler {

namespace {

using Work = std::function<int(const Attempt&)>;

class Supervisor {
 public:
  Supervisor(StatusPage& status, const Supervision& supervision, const Work& work)
      : status_(status),
        supervision_(supervision),
        work_(work),
        requests_(status),
        healer_(supervision.healing) {
    // Participants of a dead worker become children of this process, so that they can be ended and reaped.
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    std::filesystem::remove(supervision_.directory / run_report_name);
  }

  int run() {
    for (Attempt attempt = supervision_.first;; attempt = {true, attempt.epoch + 1}) {
      WorkerEnd end = live(attempt);
      if (!goes_on_after(end, attempt.epoch)) return conclude(end, attempt.epoch);
    }
  }

 private:
  /// One life of the worker; none of its processes is left afterwards.
  WorkerEnd live(const Attempt& attempt) {
    status_.begin_life();
    std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child < 0) return cannot_fork();
    if (child == 0) be_the_worker(attempt);
    ::setpgid(child, child);
    ChildProcess worker(child);
    const WorkerEnd end = WorkerWatch(status_, supervision_.deadline, requests_, worker).until_end();
    ::kill(-child, SIGKILL);
    if (!end_descendants(not_ours_))
      tell("coupler: warning: a process of the run cannot be ended: the kernel holds it");
    return end;
  }

  [[nodiscard]] static WorkerEnd cannot_fork() {
    WorkerEnd end;
    end.exit_code = end.failure.exit_code = static_cast<int>(ExitCode::precondition);
    end.failure.who = "coupler";
    end.failure.phase = "start";
    end.failure.sentence = fmt::format("cannot fork the worker: {}", std::strerror(errno));
    return end;
  }

  [[noreturn]] void be_the_worker(const Attempt& attempt) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != supervisor_) ::_exit(static_cast<int>(ExitCode::participant_died));
    ::setpgid(0, 0);
    ::setenv("FISSURA_EPOCH", std::to_string(attempt.epoch).c_str(), 1);  // for fault plans
    hold_signals_of_worker();
    dump_stack_on_request();
    status_.change([&](RunStatus& status) {
      status.epoch = attempt.epoch;
      status.started_at = monotonic_seconds();
      status.started_time = status.time;
      status.phase = "start";
      status.phase_since = status.started_at;
      status.participants = {};
    });
    const int code = work_(attempt);
    std::fflush(nullptr);
    status_.conclude(code);
    ::_exit(code);
  }

  bool goes_on_after(WorkerEnd& end, std::uint32_t epoch) {
    if (end.failure.exit_code == 0 || end.failure.exit_code > 128) return false;
    Death death{epoch, end.failure, newest_checkpoint(supervision_.directory)};
    const bool goes_on = healer_.goes_on_after(death);
    end.failure = death.failure;
    if (!goes_on) return false;
    requests_.hear();
    if (requests_.end_asked() != 0) return false;
    tell(healing_line(death));
    return true;
  }

  int conclude(const WorkerEnd& end, std::uint32_t epoch) {
    const std::optional<std::uint64_t> checkpoint = newest_checkpoint(supervision_.directory);
    const bool complete = end.failure.exit_code == 0;
    const std::string line = complete ? "" : last_line(end.failure, supervision_.directory, checkpoint);
    write({end.exit_code, end.failure, line, checkpoint, epoch, healer_.deaths(), status_.read(),
           wall_seconds()});
    if (!complete) tell(line);
    return end.exit_code;
  }

  /// The code of the run stays what it is: what ended it goes before what could not be written then.
  void write(const RunEnd& end) {
    try {
      write_whole_file(supervision_.directory / run_report_name,
                       run_report(supervision_.directory, end).dump(2) + "\n");
    } catch (const std::exception& fault) {
      tell(fmt::format("coupler: warning: {} is missing: {}", run_report_name, fault.what()));
    }
  }

  [[nodiscard]] double wall_seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  StatusPage& status_;
  const Supervision& supervision_;
  const Work& work_;
  const pid_t supervisor_ = ::getpid();
  const std::set<pid_t> not_ours_ = descendants();  ///< of the program that became this one
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  Requests requests_;
  Healer healer_;
};

}  // namespace

int supervise(StatusPage& status, const Supervision& supervision, const Work& work) {
  return Supervisor(status, supervision, work).run();
}

}  // namespace fissura::coupler
