// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/supervisor.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "coupler/launch/process_tree.hpp"
#include "tests/coupler/launch/failure.hpp"
#include "tests/coupler/temporary_directory.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

constexpr double patient = 20, impatient = 0.3;

/// A run whose worker is a function of the test.
struct SupervisedRun {
  sample::TemporaryDirectory directory;
  StatusPage status;
  Supervision supervision{directory.path(), patient, {}, {}};

  int operator()(const std::function<int(const Attempt&)>& work) {
    const int code = supervise(status, supervision, work);
    CHECK(descendants().empty());
    return code;
  }
  [[nodiscard]] nlohmann::json report() const {
    return nlohmann::json::parse(sample::content(directory.path() / "run.report.json"));
  }
};

[[noreturn]] void work_on(StatusPage& status) {
  for (;;) {
    status.beat();
    ::usleep(5000);
  }
}

int until_asked_to_end(StatusPage& status) {
  while (status.stop_signal() == 0) {
    status.beat();
    ::usleep(5000);
  }
  return 128 + status.stop_signal();
}

/// Signals to this process once the worker has shown itself, so that no signal comes before its watch.
std::thread signals_to_us(StatusPage& status, int signal, int count, useconds_t between) {
  return std::thread([&status, signal, count, between] {
    sigset_t all;
    sigfillset(&all);
    ::pthread_sigmask(SIG_BLOCK, &all, nullptr);  // they are for the thread that supervises
    while (status.beats() == 0) ::usleep(1000);
    for (int i = 0; i < count; ++i) {
      ::kill(::getpid(), signal);
      ::usleep(between);
    }
  });
}

}  // namespace

TEST_CASE("a run that is complete leaves a report that says so", "[coupler][launch]") {
  SupervisedRun run;
  CHECK(run([](const Attempt&) { return 0; }) == 0);
  CHECK(run.report()["code"] == 0);
  CHECK(run.report()["name"] == "DONE");
  CHECK(run.report()["deaths"].empty());
  CHECK_FALSE(run.report().contains("resume"));
}

TEST_CASE("the failure that the worker tells is that of the run", "[coupler][launch]") {
  SupervisedRun run;
  CHECK(run([&](const Attempt&) {
          run.status.fail(sample::failure(ExitCode::numerical_failure, "structure", 7, "not finite"));
          return 24;
        }) == 24);
  CHECK(run.report()["participant"] == "structure");
  CHECK(run.report()["interval"] == 7);
  CHECK(run.report()["cause"] == "not finite");
  CHECK(run.report()["resume"]["interval"].is_null());
}

TEST_CASE("the first fault goes before what became of the worker", "[coupler][launch]") {
  SupervisedRun run;
  CHECK(run([&](const Attempt&) -> int {
          run.status.fail(sample::failure(ExitCode::invalid_values, "network", 7, "pressure is NaN"));
          ::raise(SIGKILL);
          return 0;
        }) == 23);
  CHECK(run.report()["cause"] == "pressure is NaN");
}

TEST_CASE("a worker that leaves early with the code of success has died", "[coupler][launch]") {
  SupervisedRun run;
  CHECK(run([](const Attempt&) -> int { ::_exit(0); }) == 20);
  CHECK(run.report()["cause"] == "the coupler's worker ended early with the exit code of success");
}

TEST_CASE("a worker that a signal ends is named with the signal", "[coupler][launch]") {
  SupervisedRun run;
  CHECK(run([](const Attempt&) {
          std::signal(SIGSEGV, SIG_DFL);  // Catch2 has its own
          return ::raise(SIGSEGV);
        }) == 20);
  CHECK(run.report()["participant"] == "coupler");
  CHECK(run.report()["cause"] == "the coupler's worker was killed by signal 11 (SIGSEGV, Segmentation fault)");
}

TEST_CASE("a worker without a beat is ended at the deadline", "[coupler][launch]") {
  SupervisedRun run;
  run.supervision.deadline = impatient;
  CHECK(run([](const Attempt&) -> int {
          for (;;) ::pause();
        }) == 21);
  CHECK(run.report()["cause"] == "the coupler's worker is alive but made no progress for 0.3 s");
}

TEST_CASE("nothing is left of a worker's children, wherever they moved", "[coupler][launch]") {
  SupervisedRun run;
  CHECK(run([](const Attempt&) -> int {
          for (int child = 0; child < 3; ++child)
            if (::fork() == 0) {
              ::setsid();
              for (;;) ::pause();
            }
          return 0;
        }) == 0);
}

TEST_CASE("a healed run goes on with another worker that resumes, and keeps its deaths",
          "[coupler][launch]") {
  SupervisedRun run;
  run.supervision.healing = {true, 3};
  CHECK(run([](const Attempt& attempt) {
          if (attempt.epoch < 2) return ::raise(SIGKILL);
          return attempt.resumes ? 0 : 70;
        }) == 0);
  CHECK(run.report()["epoch"] == 2);
  CHECK(run.report()["deaths"].size() == 2);
}

TEST_CASE("healing gives up when nothing is won by it", "[coupler][launch]") {
  SupervisedRun run;
  run.supervision.healing = {true, 3};
  CHECK(run([](const Attempt&) { return ::raise(SIGKILL); }) == 20);
  CHECK(run.report()["deaths"].size() == 3);
  CHECK(run.report()["cause"].get<std::string>().find("healing ends after 3 deaths") != std::string::npos);
}

TEST_CASE("a run that was asked to end is not healed", "[coupler][launch]") {
  SupervisedRun run;
  run.supervision.healing = {true, 3};
  CHECK(run([&](const Attempt&) -> int {
          run.status.request_stop(SIGTERM);
          return ::raise(SIGKILL);
        }) == 20);
  CHECK(run.report()["deaths"].size() == 1);
}

TEST_CASE("each signal that asks for the end has its exit code", "[coupler][launch]") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    SupervisedRun run;
    std::thread user = signals_to_us(run.status, signal, 1, 0);
    CHECK(run([&](const Attempt&) { return until_asked_to_end(run.status); }) == 128 + signal);
    user.join();
    CHECK(run.report()["cause"] == "ended at a coupling time, as asked");
  }
}

TEST_CASE("a storm of signals is one request", "[coupler][launch]") {
  SupervisedRun run;
  std::thread user = signals_to_us(run.status, SIGINT, 1000, 0);
  CHECK(run([&](const Attempt&) {
          const int code = until_asked_to_end(run.status);
          for (int i = 0; i < 200; ++i) {
            run.status.beat();
            ::usleep(5000);
          }
          return code;
        }) == 130);
  user.join();
  CHECK(run.report()["phase"] == "stopped");
}

TEST_CASE("a second request ends a worker that does not come to a coupling time", "[coupler][launch]") {
  SupervisedRun run;
  std::thread user = signals_to_us(run.status, SIGINT, 2, 400'000);
  CHECK(run([&](const Attempt&) -> int { work_on(run.status); }) == 130);
  user.join();
  CHECK(run.report()["cause"] == "ended at once by signal 2 (Interrupt), as asked");
}

TEST_CASE("SIGUSR1 asks for a checkpoint and for nothing else", "[coupler][launch]") {
  SupervisedRun run;
  std::thread user = signals_to_us(run.status, SIGUSR1, 1, 0);
  CHECK(run([&](const Attempt&) {
          while (run.status.checkpoints_requested() == 0) {
            run.status.beat();
            ::usleep(5000);
          }
          return 0;
        }) == 0);
  user.join();
}

TEST_CASE("a report that cannot be written leaves the code of the run as it is", "[coupler][launch]") {
  SupervisedRun run;
  std::filesystem::create_directories(run.directory.path() / "run.report.json.part" / "in the way");
  CHECK(run([](const Attempt&) { return ::raise(SIGKILL); }) == 20);
}
