// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "coupler/launch/child_process.hpp"
#include "coupler/launch/death_watch.hpp"
#include "coupler/launch/executable_check.hpp"
#include "coupler/launch/process_activity.hpp"
#include "coupler/launch/progress_ladder.hpp"
#include "tests/coupler/temporary_directory.hpp"

using namespace fissura::coupler;
using fissura::coupler::sample::TemporaryDirectory;

TEST_CASE("of processes that ended while nobody looked, the one that ended first comes first",
          "[coupler][launch]") {
  for (const bool second_first : {false, true}) {
    ChildProcess one({"sleep", "1000"}), other({"sleep", "1000"});
    DeathWatch watch;
    watch.add(one.descriptor(), 1);
    watch.add(other.descriptor(), 2);
    CHECK(watch.ended().empty());
    for (ChildProcess* child : second_first ? std::array{&other, &one} : std::array{&one, &other}) {
      child->send_signal(SIGKILL);
      REQUIRE(child->wait(20));
    }
    CHECK(watch.ended() == (second_first ? std::vector<std::size_t>{2, 1} : std::vector<std::size_t>{1, 2}));
    CHECK(watch.ended().size() == 2);
    watch.remove(one.descriptor());
    CHECK(watch.ended() == std::vector<std::size_t>{2});
  }
}

TEST_CASE("silence is warned of, looked at, ended, each once, and anew after a word", "[coupler][launch]") {
  ProgressLadder ladder(10);
  CHECK_FALSE(ladder.climb(0.9).has_value());
  CHECK(ladder.climb(1.1) == Rung::warning);
  CHECK_FALSE(ladder.climb(1.2).has_value());
  CHECK_FALSE(ladder.climb(0.1).has_value());
  CHECK(ladder.climb(1.1) == Rung::warning);
  CHECK(ladder.climb(3.1) == Rung::diagnosis);
  CHECK_FALSE(ladder.climb(9.9).has_value());
  CHECK(ladder.climb(10.1) == Rung::end);
  CHECK_FALSE(ladder.climb(11).has_value());
}

TEST_CASE("a process that computes is told from one that sleeps", "[coupler][launch]") {
  ChildProcess busy({"sh", "-c", "while :; do :; done"}), idle({"sleep", "1000"});
  const ProcessActivity busy_before = activity_of(busy.pid()).value(),
                        idle_before = activity_of(idle.pid()).value();
  ProcessActivity busy_now = busy_before;
  while (busy_now.cpu_seconds < busy_before.cpu_seconds + 0.05) {
    ::usleep(10000);
    busy_now = activity_of(busy.pid()).value();
  }
  const ProcessActivity idle_now = activity_of(idle.pid()).value();
  CHECK(busy_now.state == 'R');
  CHECK(idle_now.state == 'S');
  CHECK(idle_now.cpu_seconds - idle_before.cpu_seconds < 0.05);
  CHECK_THAT(describe(idle_now, idle_before, 2.0),
             Catch::StartsWith("sleeps (state S)") && Catch::EndsWith("of CPU time in the last 2.00 s"));
  CHECK_FALSE(activity_of(-1).has_value());
}

TEST_CASE("a program that cannot be executed is named with the reason", "[coupler][launch]") {
  CHECK_FALSE(why_not_executable("sh -c 'exit 0'").has_value());
  CHECK_FALSE(why_not_executable("'/bin/sh' -c true").has_value());
  CHECK_FALSE(why_not_executable("$SOLVER --fast").has_value());
  CHECK(why_not_executable("/nowhere/solver --fast") == "/nowhere/solver: No such file or directory");
  CHECK(why_not_executable("\"/nowhere/my solver\"") == "/nowhere/my solver: No such file or directory");
  CHECK(why_not_executable("no-such-solver") == "no-such-solver: not found in PATH");
  CHECK(why_not_executable("/tmp") == "/tmp: not a file");
}

TEST_CASE("a program of another kind of processor is told from one of this", "[coupler][launch]") {
  const TemporaryDirectory folder;
  const std::filesystem::path program = folder.path() / "solver";
  std::filesystem::copy_file("/proc/self/exe", program);
  CHECK_FALSE(why_not_executable(program.string()).has_value());
  std::fstream file(program, std::ios::in | std::ios::out | std::ios::binary);
  constexpr int machine = 18;
  file.seekp(machine);
  file.put('\x02');
  file.close();
  CHECK_THAT(why_not_executable(program.string()).value(), Catch::Contains("another kind of processor"));
}
