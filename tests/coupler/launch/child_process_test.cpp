// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/child_process.hpp"

#include <poll.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cerrno>
#include <csignal>

#include "common/errors.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

// Generous: a busy machine may take long to schedule a process; nothing here waits for it to pass.
constexpr double patience = 20;

ProcessEnd end_of(const std::vector<std::string>& command) {
  ChildProcess child(command);
  REQUIRE(child.wait(patience));
  return *child.end();
}

bool wait_until_stopped_is(ChildProcess& child, bool wanted) {
  for (int attempt = 0; attempt < 2000; ++attempt) {
    if (child.stopped() == wanted) return true;
    ::usleep(10000);
  }
  return false;
}

}  // namespace

TEST_CASE("a process that ends by itself tells its exit code", "[coupler][launch]") {
  const ProcessEnd success = end_of({"true"});
  CHECK(success.exit_code == 0);
  CHECK_FALSE(success.signal.has_value());
  CHECK(success.sentence() == "ended early with the exit code of success");
  const ProcessEnd failure = end_of({"sh", "-c", "exit 24"});
  CHECK(failure.exit_code == 24);
  CHECK(failure.sentence() == "ended with exit code 24 (NUMERICAL-FAILURE)");
}

TEST_CASE("a process that a signal ends tells which", "[coupler][launch]") {
  ChildProcess child({"sleep", "1000"});
  CHECK_FALSE(child.end().has_value());
  child.send_signal(SIGKILL);
  REQUIRE(child.wait(patience));
  REQUIRE(child.end()->signal.has_value());
  CHECK(*child.end()->signal == SIGKILL);
  CHECK(child.end()->sentence() == "was killed by signal 9 (SIGKILL, Killed)");
}

TEST_CASE("the end of a process makes its descriptor readable", "[coupler][launch]") {
  ChildProcess child({"sleep", "1000"});
  pollfd wait{child.descriptor(), POLLIN, 0};
  CHECK(::poll(&wait, 1, 0) == 0);
  child.send_signal(SIGKILL);
  CHECK(::poll(&wait, 1, static_cast<int>(patience * 1000)) == 1);
}

TEST_CASE("a stopped process is stopped, not ended, until it continues", "[coupler][launch]") {
  ChildProcess child({"sleep", "1000"});
  CHECK_FALSE(child.stopped());
  child.send_signal(SIGSTOP);
  CHECK(wait_until_stopped_is(child, true));
  CHECK_FALSE(child.end().has_value());
  CHECK_FALSE(child.wait(0));
  child.send_signal(SIGCONT);
  CHECK(wait_until_stopped_is(child, false));
  child.send_signal(SIGSTOP);
  CHECK(wait_until_stopped_is(child, true));
  CHECK(*child.wait_or_kill(0).signal == SIGKILL);
  CHECK_FALSE(child.stopped());
}

TEST_CASE("a program that is not there is named at once, with the reason", "[coupler][launch]") {
  CHECK_THROWS_WITH(ChildProcess({"/nowhere/solver", "--fast"}),
                    Catch::Contains("/nowhere/solver") && Catch::Contains("No such file or directory"));
  try {
    const ChildProcess child({"/nowhere/solver"});
    FAIL("it was started");
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::precondition);
  }
}

TEST_CASE("a command that a shell does not find is called by that name", "[coupler][launch]") {
  const ProcessEnd end = end_of({"sh", "-c", "exec /nowhere/solver 2>/dev/null"});
  CHECK(end.exit_code == 127);
  CHECK(end.sentence() == "ended with exit code 127 (command not found)");
}

TEST_CASE("no process outlives the object that watches it", "[coupler][launch]") {
  pid_t pid = 0;
  {
    const ChildProcess child({"sleep", "1000"});
    pid = child.pid();
    CHECK(::kill(pid, 0) == 0);
  }
  CHECK(::kill(pid, 0) == -1);
  CHECK(errno == ESRCH);
}

TEST_CASE("a moved process is watched by its new owner alone", "[coupler][launch]") {
  ChildProcess first({"sh", "-c", "exit 7"});
  ChildProcess second(std::move(first));
  REQUIRE(second.wait(patience));
  CHECK(second.end()->exit_code == 7);
}
