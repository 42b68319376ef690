// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/memory_kills.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "tests/coupler/temporary_directory.hpp"

using namespace fissura::coupler;

TEST_CASE(
    "kills for want of memory are counted where the kernel of either version of control groups tells them",
    "[coupler][launch]") {
  CHECK(memory_events_file("0::/user.slice/run.scope\n") ==
        "/sys/fs/cgroup/user.slice/run.scope/memory.events");
  CHECK(memory_events_file("5:devices:/\n4:memory:/jobs/7\n0::/\n") ==
        "/sys/fs/cgroup/memory/jobs/7/memory.oom_control");
  CHECK(memory_events_file("").empty());
}

TEST_CASE("the count of kills is that of oom_kill alone", "[coupler][launch]") {
  const sample::TemporaryDirectory folder;
  const std::string file = folder.path() / "memory.events";
  CHECK_FALSE(memory_kills_in(file));
  std::ofstream(file) << "low 0\nhigh 0\nmax 31\noom 5\noom_kill 2\noom_group_kill 0\n";
  CHECK(memory_kills_in(file) == 2);
  std::ofstream(file) << "oom_kill_disable 0\nunder_oom 0\noom_kill 3\n";
  CHECK(memory_kills_in(file) == 3);
  std::ofstream(file) << "low 0\noom 5\n";
  CHECK_FALSE(memory_kills_in(file));
}
