// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <sstream>

#include "common/hash.hpp"
#include "coupler/record/run_record.hpp"
#include "coupler/record/sealed_line.hpp"
#include "tests/coupler/checkpoint/sample_checkpoint.hpp"
#include "tests/coupler/checkpoint/unsynced_disk.hpp"
#include "tests/coupler/record/scripted_run.hpp"
#include "tests/coupler/temporary_directory.hpp"

using namespace fissura;
using namespace fissura::coupler;
using sample::Loss;

namespace fs = std::filesystem;

namespace {

/// Calls `look(what is found)` for both kinds of loss at every moment at which `work(directory)` syncs or
/// renames something.
template <typename Work, typename Look>
void lose_power_throughout(const fs::path& directory, const Work& work, const Look& look) {
  const sample::TemporaryDirectory copies;
  int moments = 0;
  const sample::UnsyncedDisk* disk = nullptr;
  const sample::UnsyncedDisk watched(directory, [&] {
    for (const Loss loss : {Loss::everything, Loss::contents}) {
      const fs::path copy = copies.path() / std::to_string(moments++);
      disk->leave_behind(loss, copy);
      INFO("moment " << moments << (loss == Loss::everything ? ", names lost" : ", names kept"));
      look(copy);
      fs::remove_all(copy);
    }
  });
  disk = &watched;
  work(directory);
  CHECK(moments > 20);
}

void check_segments(const fs::path& directory) {
  const fs::path index = directory / "segments" / "index.jsonl";
  if (!fs::exists(index)) return;
  std::istringstream lines(sample::content(index));
  for (std::string line; std::getline(lines, line) && !lines.eof();) {
    const nlohmann::json segment = opened_line(line);
    const fs::path file = directory / "segments" / segment.at("file").get<std::string>();
    REQUIRE(fs::exists(file));
    CHECK(sha256_of_file(file) == segment.at("sha256"));
  }
}

}  // namespace

TEST_CASE("whenever the power fails, the last checkpoint that was written, or the next, is whole",
          "[coupler][checkpoint][faults]") {
  const sample::TemporaryDirectory folder;
  std::uint64_t written = 0;
  lose_power_throughout(
      folder.path(),
      [&](const fs::path& directory) {
        CheckpointStore store(directory, 2);
        for (const std::uint64_t interval : {1, 2, 3, 3, 4}) {
          store.write(sample::checkpoint(interval));
          written = interval;
        }
        store.set_aside_newer_than(3);
        written = 3;
        store.write(sample::checkpoint(5));
      },
      [&](const fs::path& found) {
        const CheckpointStore store(found, 2);
        const FoundCheckpoint newest = store.newest_whole();
        CHECK(newest.unusable.empty());
        REQUIRE(newest.checkpoint.has_value() == (written > 0 || newest.checkpoint.has_value()));
        if (!newest.checkpoint) return;
        const std::uint64_t interval = newest.checkpoint->manifest.interval;
        CHECK(interval >= std::min<std::uint64_t>(written, 3));
        CHECK(newest.checkpoint->states == sample::checkpoint(interval).states);
      });
}

TEST_CASE("whenever the power fails, closed segments are whole and the record can go on from the checkpoint",
          "[coupler][checkpoint][faults]") {
  const sample::TemporaryDirectory folder;
  bool has_checkpoint = false;
  lose_power_throughout(
      folder.path(),
      [&](const fs::path& directory) {
        RunRecord record(directory, sample::reports_per_segment);
        CheckpointStore store(directory, 2);
        record.begin(sample::description());
        for (std::uint64_t interval = 1; interval <= 16; ++interval) {
          sample::record_interval(record, interval);
          if (interval % 5 != 0) continue;
          Checkpoint checkpoint = sample::checkpoint(interval);
          checkpoint.states["record"] = record.save();
          store.write(std::move(checkpoint));
          has_checkpoint = true;
        }
      },
      [&](const fs::path& found) {
        check_segments(found);
        const FoundCheckpoint newest = CheckpointStore(found, 2).newest_whole();
        REQUIRE(newest.checkpoint.has_value() >= has_checkpoint);
        if (newest.checkpoint) CHECK_NOTHROW(RunRecord::check(found, newest.checkpoint->states.at("record")));
      });
}
