// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/process_tree.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>

#include "coupler/launch/child_process.hpp"

using namespace fissura::coupler;

namespace {

constexpr int attempts = 2000;

bool becomes(std::size_t count) {
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (descendants().size() == count) return true;
    ::usleep(5000);
  }
  return false;
}

/// Orphans of this process come to it while this object lives.
struct Subreaper {
  Subreaper() { ::prctl(PR_SET_CHILD_SUBREAPER, 1); }
  ~Subreaper() { ::prctl(PR_SET_CHILD_SUBREAPER, 0); }
};

}  // namespace

TEST_CASE("every descendant is ended, also one that moved to another session or lost its parent",
          "[coupler][launch]") {
  const Subreaper subreaper;
  // A child with a child of its own in another session, and an orphan in another session.
  ChildProcess child({"sh", "-c", "setsid sleep 1000 & (setsid sleep 1000 &) ; exec sleep 1000"});
  REQUIRE(becomes(3));
  CHECK(end_descendants({}));
  CHECK(descendants().empty());
}

TEST_CASE("processes that were there before are spared", "[coupler][launch]") {
  const Subreaper subreaper;
  ChildProcess before({"sleep", "1000"});
  const std::set<pid_t> spared = descendants();
  REQUIRE(spared.size() == 1);
  {
    ChildProcess after({"sleep", "1000"});
    CHECK(end_descendants(spared));
  }
  CHECK(descendants() == spared);
  CHECK_FALSE(before.end().has_value());
}

TEST_CASE("processes that keep forking are ended", "[coupler][launch]") {
  const Subreaper subreaper;
  ChildProcess child({"sh", "-c", "while true; do setsid sleep 1000 & sleep 0.005; done"});
  ::usleep(200000);
  CHECK(end_descendants({}));
  CHECK(descendants().empty());
}
