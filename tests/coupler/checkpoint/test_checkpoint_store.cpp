// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdio>
#include <fstream>

#include "common/errors.hpp"
#include "tests/coupler/checkpoint/sample_checkpoint.hpp"
#include "tests/coupler/temporary_directory.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace fs = std::filesystem;

TEST_CASE("a checkpoint comes back with every byte of every state", "[coupler][checkpoint]") {
  const sample::TemporaryDirectory folder;
  CheckpointStore store(folder.path(), 2);
  CHECK_FALSE(store.newest_whole().checkpoint);
  CHECK(fs::is_empty(folder.path()));
  store.write(sample::checkpoint(42));
  const FoundCheckpoint found = store.newest_whole();
  REQUIRE(found.checkpoint);
  CHECK(found.unusable.empty());
  CHECK(found.checkpoint->states == sample::checkpoint(42).states);
  CHECK(found.checkpoint->manifest.provenance == sample::provenance());
  CHECK(found.checkpoint->manifest.interval == 42);
  CHECK(found.checkpoint->manifest.files.at("scheme").bytes == 0);
}

TEST_CASE("after each checkpoint the two newest are there, and nothing else", "[coupler][checkpoint]") {
  const sample::TemporaryDirectory folder;
  CheckpointStore store(folder.path(), 2);
  std::vector<std::string> expected;
  for (const std::uint64_t interval : {8, 9, 10, 999'999, 1'000'000}) {
    store.write(sample::checkpoint(interval));
    expected.push_back(interval < 1'000'000
                           ? std::string(6 - std::to_string(interval).size(), '0') + std::to_string(interval)
                           : "1000000");
    if (expected.size() > 2) expected.erase(expected.begin());
    CHECK(store.names() == expected);
    std::size_t entries = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder.path() / "checkpoints"))
      ++entries;
    CHECK(entries == expected.size());
    CHECK(store.newest_whole().checkpoint->manifest.interval == interval);
  }
}

TEST_CASE("between the phases the older checkpoint is the newest", "[coupler][checkpoint]") {
  const sample::TemporaryDirectory folder;
  CheckpointStore store(folder.path(), 2);
  store.write(sample::checkpoint(1));
  store.prepare(sample::checkpoint(2));
  CHECK(store.newest_whole().checkpoint->manifest.interval == 1);
  CHECK(CheckpointStore(folder.path(), 2).newest_whole().unusable.empty());
  store.commit();
  CHECK(store.newest_whole().checkpoint->manifest.interval == 2);
}

TEST_CASE("what a killed writer left behind is ignored, and goes with the next checkpoint",
          "[coupler][checkpoint]") {
  const sample::TemporaryDirectory folder;
  {
    CheckpointStore killed(folder.path(), 2);
    killed.write(sample::checkpoint(1));
    killed.prepare(sample::checkpoint(2));
  }
  CheckpointStore store(folder.path(), 2);
  REQUIRE(fs::exists(folder.path() / "checkpoints" / "000002.part" / "MANIFEST.json"));
  CHECK(store.names() == std::vector<std::string>{"000001"});
  store.write(sample::checkpoint(3));
  CHECK_FALSE(fs::exists(folder.path() / "checkpoints" / "000002.part"));
  CHECK(store.names() == std::vector<std::string>{"000001", "000003"});
}

TEST_CASE("the same interval again replaces a damaged checkpoint", "[coupler][checkpoint]") {
  const sample::TemporaryDirectory folder;
  CheckpointStore store(folder.path(), 2);
  for (const std::uint64_t interval : {1, 2}) store.write(sample::checkpoint(interval));
  fs::remove(folder.path() / "checkpoints" / "000002" / "network.state");
  REQUIRE(store.newest_whole().checkpoint->manifest.interval == 1);
  store.write(sample::checkpoint(2));
  CHECK(store.newest_whole().checkpoint->manifest.interval == 2);
  CHECK(store.names() == std::vector<std::string>{"000001", "000002"});
}

TEST_CASE("going on from an older checkpoint puts newer ones aside for good", "[coupler][checkpoint]") {
  const sample::TemporaryDirectory folder;
  CheckpointStore store(folder.path(), 3);
  for (const std::uint64_t interval : {1, 2, 7}) store.write(sample::checkpoint(interval));
  store.set_aside_newer_than(2);
  CHECK(store.names() == std::vector<std::string>{"000001", "000002"});
  CHECK(fs::exists(folder.path() / "checkpoints" / "000007.unusable"));
  store.write(sample::checkpoint(3));
  CHECK(store.newest_whole().checkpoint->manifest.interval == 3);
  CHECK_FALSE(fs::exists(folder.path() / "checkpoints" / "000007.unusable"));
  store.set_aside_newer_than(std::nullopt);
  CHECK(store.names().empty());
  CHECK_FALSE(store.newest_whole().checkpoint);
}

TEST_CASE("whoever refuses a whole checkpoint gets the next older one", "[coupler][checkpoint]") {
  const sample::TemporaryDirectory folder;
  CheckpointStore store(folder.path(), 2);
  for (const std::uint64_t interval : {1, 2}) store.write(sample::checkpoint(interval));
  const FoundCheckpoint found = store.newest_usable([](const Checkpoint& checkpoint) {
    return checkpoint.manifest.interval == 2 ? std::optional<std::string>("history.csv is shorter")
                                             : std::nullopt;
  });
  CHECK(found.checkpoint->manifest.interval == 1);
  REQUIRE(found.unusable.size() == 1);
  CHECK(found.unusable[0].name == "000002");
  CHECK(found.unusable[0].reason == "history.csv is shorter");
}

TEST_CASE("a state that cannot be written leaves the older checkpoint and no part", "[coupler][checkpoint]") {
  const sample::TemporaryDirectory folder;
  CheckpointStore(folder.path(), 2).write(sample::checkpoint(1));
  std::fflush(nullptr);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1 << 16, 1 << 16};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    int code = 0;
    try {
      Checkpoint large = sample::checkpoint(2);
      large.states["structure"].resize(1 << 17);
      CheckpointStore(folder.path(), 2).write(std::move(large));
    } catch (const Error& failure) {
      code = static_cast<int>(failure.code());
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == static_cast<int>(ExitCode::storage_failure));
  const CheckpointStore store(folder.path(), 2);
  CHECK(store.newest_whole().checkpoint->states == sample::checkpoint(1).states);
  CHECK_FALSE(fs::exists(folder.path() / "checkpoints" / "000002.part"));
}

TEST_CASE("a checkpoint that cannot be created says where and why", "[coupler][checkpoint]") {
  const sample::TemporaryDirectory folder;
  std::ofstream(folder.path() / "checkpoints") << "a file";
  CheckpointStore store(folder.path(), 2);
  CHECK_THROWS_AS(store.write(sample::checkpoint(1)), StorageError);
  CHECK_THROWS_WITH(store.write(sample::checkpoint(1)), Catch::Contains("checkpoints"));
  CHECK_FALSE(store.newest_whole().checkpoint);
}

TEST_CASE("a folder of checkpoints that cannot be read is not taken for an empty one",
          "[coupler][checkpoint]") {
  const sample::TemporaryDirectory folder;
  fs::create_symlink("checkpoints", folder.path() / "checkpoints");
  const CheckpointStore store(folder.path(), 2);
  CHECK_THROWS_AS(store.names(), StorageError);
  CHECK_THROWS_AS(store.newest_whole(), StorageError);
}
