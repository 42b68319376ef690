// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <set>

#include "common/errors.hpp"
#include "coupler/record/checksums.hpp"
#include "tests/coupler/record/sample_run.hpp"
#include "tests/coupler/record/scripted_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t last = 23;

/// Begins a run, saves its record after `saved` intervals and goes on to `killed`, where it just ends.
std::vector<std::byte> begun_run(const fs::path& directory, std::uint64_t saved, std::uint64_t killed) {
  RunRecord record(directory, sample::reports_per_segment);
  record.begin(sample::description());
  sample::record_intervals(record, 1, saved);
  const std::vector<std::byte> state = record.save();
  sample::record_intervals(record, saved + 1, killed);
  return state;
}

void resume_and_finish(const fs::path& directory, const std::vector<std::byte>& state, std::uint64_t saved) {
  RunRecord record(directory, sample::reports_per_segment);
  RunRecord::check(directory, state);
  record.resume(sample::description(), state);
  sample::record_intervals(record, saved + 1, last);
  record.finish({{"verdict", "none"}, {"intervals", last}});
}

const std::map<std::string, std::string>& uninterrupted() {
  static const std::map<std::string, std::string> files = [] {
    const sample::TemporaryDirectory folder;
    sample::record_run(folder.path(), last);
    return sample::comparable_files(folder.path());
  }();
  return files;
}

std::size_t superseded_in(const fs::path& directory) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(directory / "segments"))
    count += entry.path().extension() == ".superseded";
  return count;
}

}  // namespace

TEST_CASE("a run that was ended anywhere and went on leaves the bytes of one that was not",
          "[coupler][record][resume]") {
  for (const std::uint64_t saved : {0, 1, 4, 5, 6, 7, 12, 22, 23})
    for (const std::uint64_t lost : {0, 1, 8}) {
      const std::uint64_t killed = std::min(saved + lost, last);
      INFO("saved after " << saved << ", ended after " << killed);
      const sample::TemporaryDirectory folder;
      const std::vector<std::byte> state = begun_run(folder.path(), saved, killed);
      resume_and_finish(folder.path(), state, saved);
      CHECK(sample::differences(sample::comparable_files(folder.path()), uninterrupted()) ==
            std::vector<std::string>());
    }
}

TEST_CASE("a run that stopped in good order, with its last segment closed, goes on as well",
          "[coupler][record][resume]") {
  const sample::TemporaryDirectory folder;
  std::vector<std::byte> state;
  {
    RunRecord record(folder.path(), sample::reports_per_segment);
    record.begin(sample::description());
    sample::record_intervals(record, 1, 8);
    state = record.save();
    record.finish({{"verdict", "none"}});
  }
  REQUIRE(fs::exists(folder.path() / "segments" / "000002.h5"));
  resume_and_finish(folder.path(), state, 8);
  CHECK(superseded_in(folder.path()) == 1);
  CHECK(sample::differences(sample::comparable_files(folder.path()), uninterrupted()) ==
        std::vector<std::string>());
}

TEST_CASE("superseded segments are never lost, however often a run goes on", "[coupler][record][resume]") {
  const sample::TemporaryDirectory folder;
  const std::vector<std::byte> state = begun_run(folder.path(), 1, 13);
  REQUIRE(fs::exists(folder.path() / "segments" / "000002.h5"));
  for (const std::size_t lives : {1, 2, 3}) {
    RunRecord record(folder.path(), sample::reports_per_segment);
    record.resume(sample::description(), state);
    CHECK(superseded_in(folder.path()) == 2 * lives);
    CHECK_FALSE(fs::exists(folder.path() / "segments" / "000001.h5"));
    CHECK(sample::lines(folder.path() / "history.csv").size() == 2);
    CHECK(record.history().size() == 1);
    sample::record_intervals(record, 2, 13);
  }
  resume_and_finish(folder.path(), state, 1);
  CHECK(sample::differences(sample::comparable_files(folder.path()), uninterrupted()) ==
        std::vector<std::string>());
}

TEST_CASE("the series are the same after a resume, every bit", "[coupler][record][resume]") {
  const sample::TemporaryDirectory one, other;
  RunRecord straight(one.path(), sample::reports_per_segment);
  straight.begin(sample::description());
  sample::record_intervals(straight, 1, 9);
  const std::vector<std::byte> state = begun_run(other.path(), 9, 12);
  RunRecord resumed(other.path(), sample::reports_per_segment);
  resumed.resume(sample::description(), state);
  for (const char* name :
       {"time", "inlet_aperture", "source_moment_xy", "probe.near.stress_xx", "probe.far.stress_xx_change"}) {
    const auto before = straight.history().series(name).value(),
               after = resumed.history().series(name).value();
    CHECK(std::vector<double>(before.begin(), before.end()) ==
          std::vector<double>(after.begin(), after.end()));
  }
  CHECK(resumed.history().last().interval == 9);
  CHECK(resumed.history().last().seismicity.events == straight.history().last().seismicity.events);
  CHECK(resumed.meeting_totals().met == straight.meeting_totals().met);
  CHECK(resumed.remesh_totals().largest_touched == straight.remesh_totals().largest_touched);
}

TEST_CASE("the log of all lives is one, and a line that was cut off is gone", "[coupler][record][resume]") {
  const sample::TemporaryDirectory folder;
  const std::vector<std::byte> state = begun_run(folder.path(), 5, 13);
  const std::size_t before = sample::lines(folder.path() / "log.jsonl").size();
  std::ofstream(folder.path() / "log.jsonl", std::ios::app) << "{\"interval\":14,\"ti";
  RunRecord record(folder.path(), sample::reports_per_segment);
  record.resume(sample::description(), state);
  record.event(EventLevel::info, "coupler", "resume", "goes on");
  const auto lines = sample::lines(folder.path() / "log.jsonl");
  REQUIRE(lines.size() == before + 1);
  CHECK(nlohmann::json::parse(lines.back())["event"] == "resume");
  CHECK(nlohmann::json::parse(lines.back())["interval"] == 5);
}

TEST_CASE("a table that is shorter than it was, or another, is named, and nothing is changed",
          "[coupler][record][resume]") {
  const sample::TemporaryDirectory folder;
  const std::vector<std::byte> state = begun_run(folder.path(), 12, 14);
  const std::set<std::string> tables{"history.csv",         "ledger.csv",   "probes.csv",
                                     "remeshing.csv",       "meetings.csv", "remeshing_wall.csv",
                                     "segments/index.jsonl"};
  for (const std::string& name : tables) {
    const fs::path file = folder.path() / name;
    const std::string sound = sample::content(file);
    std::string flipped = sound;
    flipped[flipped.size() / 3] ^= 1;
    for (const std::string& damaged : {flipped, sound.substr(0, sound.size() / 3), std::string()}) {
      std::ofstream(file, std::ios::binary | std::ios::trunc) << damaged;
      const auto before = sample::comparable_files(folder.path());
      CHECK_THROWS_WITH(RunRecord::check(folder.path(), state), Catch::Contains(name));
      RunRecord record(folder.path(), sample::reports_per_segment);
      CHECK_THROWS_WITH(record.resume(sample::description(), state), Catch::Contains(name));
      CHECK(sample::differences(sample::comparable_files(folder.path()), before) ==
            std::vector<std::string>());
    }
    fs::remove(file);
    CHECK_THROWS_WITH(RunRecord::check(folder.path(), state), Catch::Contains(name));
    std::ofstream(file, std::ios::binary) << sound;
  }
  CHECK_NOTHROW(RunRecord::check(folder.path(), state));
}

TEST_CASE("a state of the record that is cut off or of another program is refused",
          "[coupler][record][resume]") {
  const sample::TemporaryDirectory folder;
  std::vector<std::byte> state = begun_run(folder.path(), 6, 6);
  for (const std::size_t length : {std::size_t{0}, std::size_t{20}, state.size() / 2, state.size() - 1}) {
    RunRecord record(folder.path(), sample::reports_per_segment);
    CHECK_THROWS_AS(record.resume(sample::description(), {state.begin(), state.begin() + length}), Error);
  }
  state[8] = std::byte{'x'};
  CHECK_THROWS_WITH(RunRecord::check(folder.path(), state), Catch::Contains("another version"));
}

TEST_CASE(
    "a run.json in the state of the record that is not as it was closed is refused before anything changes",
    "[coupler][record][resume]") {
  const sample::TemporaryDirectory folder;
  const std::vector<std::byte> state = begun_run(folder.path(), 6, 8);
  const auto before = sample::comparable_files(folder.path());
  constexpr std::string_view entry = "\"started\"";
  const auto found = std::search(state.begin(), state.end(), entry.begin(), entry.end(),
                                 [](std::byte one, char other) { return static_cast<char>(one) == other; });
  REQUIRE(found != state.end());
  const std::ptrdiff_t quote = found - state.begin(), letter = quote + 1;
  for (const std::ptrdiff_t place : {quote, letter}) {
    std::vector<std::byte> changed = state;
    changed[place] = std::byte{'x'};
    RunRecord record(folder.path(), sample::reports_per_segment);
    CHECK_THROWS_MATCHES(record.resume(sample::description(), changed), Error,
                         Catch::Predicate<Error>([](const Error& fault) {
                           return fault.code() == ExitCode::checkpoint_unusable;
                         }));
    CHECK(sample::differences(sample::comparable_files(folder.path()), before) == std::vector<std::string>());
  }
}

TEST_CASE("a run without checkpoint begins anew in its directory and loses nothing that was closed",
          "[coupler][record][resume]") {
  const sample::TemporaryDirectory folder;
  (void)begun_run(folder.path(), 5, 20);
  std::ofstream(folder.path() / "segments" / "000009.h5.part") << "half";
  const std::string started = nlohmann::json::parse(sample::content(folder.path() / "run.json"))["started"];
  sample::record_run(folder.path(), last);
  CHECK(sample::differences(sample::comparable_files(folder.path()), uninterrupted()) ==
        std::vector<std::string>());
  CHECK(superseded_in(folder.path()) == 3);
  CHECK(nlohmann::json::parse(sample::content(folder.path() / "run.json"))["started"] == started);
}

TEST_CASE("the checksums of a finished run name every result, with the hash of what was written",
          "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  {
    RunRecord record(folder.path(), sample::reports_per_segment);
    record.begin(sample::description());
    sample::record_intervals(record, 1, 12);
    std::ofstream(folder.path() / "segments" / "000001.h5", std::ios::app) << "x";
    record.finish({{"verdict", "none"}});
  }
  const Checksums sums = read_checksums(folder.path() / "SHA256SUMS");
  for (const char* name : {"history.csv", "summary.json", "segments/000002.h5", "log.jsonl", "meetings.csv"})
    CHECK(sums.contains(name));
  const std::string command =
      "cd " + folder.path().string() + " && LC_ALL=C sha256sum --check SHA256SUMS > sums.txt 2>/dev/null";
  CHECK(std::system(command.c_str()) != 0);
  for (const std::string& line : sample::lines(folder.path() / "sums.txt"))
    CHECK(line.ends_with("OK") == !line.starts_with("segments/000001.h5"));
}

TEST_CASE("a table that was damaged behind the back of the run is found when it ends", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  RunRecord record(folder.path(), sample::reports_per_segment);
  record.begin(sample::description());
  sample::record_intervals(record, 1, 12);
  (void)record.save();
  {
    std::fstream ledger(folder.path() / "ledger.csv", std::ios::in | std::ios::out);
    ledger.seekp(200);
    ledger.put('7');
  }
  CHECK_THROWS_WITH(record.finish({{"verdict", "none"}}), Catch::Contains("ledger.csv"));
}
