// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "common/errors.hpp"
#include "tests/coupler/checkpoint/sample_checkpoint.hpp"
#include "tests/coupler/temporary_directory.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace fs = std::filesystem;

namespace {

/// Two checkpoints, 1 and 2; whatever is done to the newer one, the older must be found, and the file named.
class TwoCheckpoints {
 public:
  TwoCheckpoints() : store(folder_.path(), 2) {
    for (const std::uint64_t interval : {1, 2}) store.write(sample::checkpoint(interval));
  }
  [[nodiscard]] fs::path newer() const { return folder_.path() / "checkpoints" / "000002"; }
  [[nodiscard]] fs::path older() const { return folder_.path() / "checkpoints" / "000001"; }
  void expect_older_because_of(const std::string& word) const {
    const FoundCheckpoint found = store.newest_whole();
    REQUIRE(found.checkpoint);
    CHECK(found.checkpoint->states == sample::checkpoint(1).states);
    REQUIRE(found.unusable.size() == 1);
    CHECK(found.unusable[0].name == "000002");
    CHECK_THAT(found.unusable[0].reason, Catch::Contains(word));
  }

 private:
  sample::TemporaryDirectory folder_;

 public:
  CheckpointStore store;
};

void overwrite(const fs::path& file, const std::string& content) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << content;
}

}  // namespace

TEST_CASE("every flipped byte of every file of a checkpoint is found, and the older one taken",
          "[coupler][checkpoint]") {
  const TwoCheckpoints run;
  for (const auto& entry : fs::directory_iterator(run.newer())) {
    const std::string sound = sample::content(entry.path());
    for (std::size_t position = 0; position < sound.size(); ++position) {
      std::string damaged = sound;
      damaged[position] = static_cast<char>(damaged[position] ^ (1 << (position % 8)));
      overwrite(entry.path(), damaged);
      run.expect_older_because_of(entry.path().filename().string());
    }
    overwrite(entry.path(), sound);
  }
  CHECK(run.store.newest_whole().checkpoint->manifest.interval == 2);
}

TEST_CASE("a file of a checkpoint that is cut short, empty, longer, missing or no file is named",
          "[coupler][checkpoint]") {
  const TwoCheckpoints run;
  for (const char* name : {"structure.state", "record.state", "MANIFEST.json"}) {
    const fs::path file = run.newer() / name;
    const std::string sound = sample::content(file);
    overwrite(file, sound.substr(0, sound.size() / 2));
    run.expect_older_because_of(name);
    overwrite(file, "");
    run.expect_older_because_of(name);
    overwrite(file, sound + "x");
    run.expect_older_because_of(name);
    fs::remove(file);
    run.expect_older_because_of(name);
    fs::create_directory(file);
    run.expect_older_because_of(name);
    fs::remove(file);
    fs::create_symlink("/dev/zero", file);
    run.expect_older_because_of(name);
    fs::remove(file);
    overwrite(file, sound);
  }
  CHECK(run.store.newest_whole().checkpoint->manifest.interval == 2);
}

TEST_CASE("states swapped between roles, or taken from another checkpoint, are found",
          "[coupler][checkpoint]") {
  const TwoCheckpoints run;
  SECTION("between roles") {
    fs::rename(run.newer() / "structure.state", run.newer() / "x");
    fs::rename(run.newer() / "network.state", run.newer() / "structure.state");
    fs::rename(run.newer() / "x", run.newer() / "network.state");
    run.expect_older_because_of("network.state");
  }
  SECTION("from the older one") {
    fs::copy_file(run.older() / "structure.state", run.newer() / "structure.state",
                  fs::copy_options::overwrite_existing);
    run.expect_older_because_of("structure.state");
  }
  SECTION("a renamed folder") {
    fs::remove_all(run.newer());
    fs::copy(run.older(), run.newer(), fs::copy_options::recursive);
    run.expect_older_because_of("interval 1");
  }
}

TEST_CASE("checkpoints of another case or program are refused with what differs", "[coupler][checkpoint]") {
  const TwoCheckpoints run;
  Provenance other = sample::provenance();
  other.program = "0.2.0 7654321";
  const FoundCheckpoint found = run.store.newest_usable([&](const Checkpoint& checkpoint) {
    const auto reason = mismatch(checkpoint.manifest.provenance, other);
    return reason ? std::optional("it is " + *reason) : std::nullopt;
  });
  CHECK_FALSE(found.checkpoint);
  REQUIRE(found.unusable.size() == 2);
  CHECK_THAT(found.unusable[0].reason,
             Catch::Contains("another program") && Catch::Contains("0.2.0 7654321"));
}

TEST_CASE("without a whole checkpoint all are told of, newest first", "[coupler][checkpoint]") {
  const TwoCheckpoints run;
  fs::remove(run.newer() / "MANIFEST.json");
  overwrite(run.older() / "network.state", "");
  const FoundCheckpoint found = run.store.newest_whole();
  CHECK_FALSE(found.checkpoint);
  REQUIRE(found.unusable.size() == 2);
  CHECK(found.unusable[0].name == "000002");
  CHECK_THAT(found.unusable[1].reason, Catch::Contains("000001") && Catch::Contains("network.state"));
}
