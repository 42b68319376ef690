// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <fstream>

#include "common/case/case.hpp"
#include "common/errors.hpp"
#include "coupler/checkpoint/checkpoint_store.hpp"
#include "coupler/cli/verify_command.hpp"
#include "coupler/cli/verify_run.hpp"
#include "coupler/scheme/seismic_monitor.hpp"
#include "tests/coupler/record/sample_run.hpp"
#include "tests/coupler/record/scripted_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace fs = std::filesystem;

namespace {

/// A run of 14 intervals with checkpoints after 6 and 10, ended in good order or not.
class Run {
 public:
  enum class End { finished, killed };
  explicit Run(End end) {
    RunRecord record(path(), sample::reports_per_segment);
    record.begin(sample::description());
    CheckpointStore store(path(), 2);
    for (std::uint64_t interval = 1; interval <= 14; ++interval) {
      sample::record_interval(record, interval);
      if (interval != 6 && interval != 10) continue;
      Checkpoint checkpoint;
      checkpoint.manifest.interval = interval;
      checkpoint.states["record"] = record.save();
      store.write(std::move(checkpoint));
    }
    if (end == End::finished) record.finish({{"verdict", "none"}});
  }
  [[nodiscard]] const fs::path& path() const { return folder_.path(); }
  [[nodiscard]] std::vector<std::string> damaged() const {
    std::vector<std::string> names;
    for (const Finding& finding : verify_run(path()))
      if (finding.soundness == Soundness::damaged) names.push_back(finding.name);
    return names;
  }
  [[nodiscard]] std::string told_of(const std::string& name) const {
    for (const Finding& finding : verify_run(path()))
      if (finding.name == name && finding.soundness == Soundness::damaged) return finding.text;
    return "nothing";
  }

 private:
  sample::TemporaryDirectory folder_;
};

using Names = std::vector<std::string>;

void flip(const fs::path& file, std::size_t position) {
  std::string content = sample::content(file);
  content.at(position) ^= 4;
  std::ofstream(file, std::ios::binary | std::ios::trunc) << content;
}

}  // namespace

TEST_CASE("a sound run is told to be sound, finished or not", "[coupler][cli][verify]") {
  CHECK(Run(Run::End::finished).damaged() == Names());
  CHECK(Run(Run::End::killed).damaged() == Names());
  CHECK(verify_command(Run(Run::End::finished).path()) == 0);
}

TEST_CASE("one flipped bit in any result of a finished run is found, and the file named",
          "[coupler][cli][verify]") {
  const Run run(Run::End::finished);
  for (const auto& entry : fs::recursive_directory_iterator(run.path())) {
    const std::string name = fs::relative(entry.path(), run.path()).string();
    if (!entry.is_regular_file() || name == "lock" || name.starts_with("checkpoints")) continue;
    INFO(name);
    const std::string sound = sample::content(entry.path());
    for (const std::size_t position : {std::size_t{0}, sound.size() / 2, sound.size() - 2}) {
      flip(entry.path(), position);
      const Names found = run.damaged();
      // A damaged table of checksums no longer names the file it was damaged at.
      if (name == "SHA256SUMS")
        CHECK_FALSE(found.empty());
      else
        CHECK(std::find(found.begin(), found.end(), name) != found.end());
      std::ofstream(entry.path(), std::ios::binary | std::ios::trunc) << sound;
    }
  }
  CHECK(run.damaged() == Names());
}

TEST_CASE("a damaged segment is told with the arrays that are lost", "[coupler][cli][verify]") {
  const Run run(Run::End::killed);
  const fs::path segment = run.path() / "segments" / "000001.h5";
  const std::string content = sample::content(segment);
  // The stress of the first report: its greatest compression, written down in the sample.
  const double stress = -1e7;
  const std::string bytes(reinterpret_cast<const char*>(&stress), sizeof(stress));
  flip(segment, content.find(bytes));
  CHECK(run.damaged() == Names{"segments/000001.h5"});
  CHECK_THAT(run.told_of("segments/000001.h5"),
             Catch::Contains("/structure/stress") && !Catch::Contains("displacement"));
  CHECK(verify_command(run.path()) == static_cast<int>(ExitCode::storage_failure));
  fs::remove(segment);
  CHECK_THAT(run.told_of("segments/000001.h5"), Catch::Contains("missing"));
}

TEST_CASE("tables of a run that did not finish are compared with its newest whole checkpoint",
          "[coupler][cli][verify]") {
  const Run run(Run::End::killed);
  for (const char* name : {"history.csv", "ledger.csv", "probes.csv", "remeshing.csv", "meetings.csv"}) {
    const std::string sound = sample::content(run.path() / name);
    std::string other = sound;
    // Another digit: still a table of numbers.
    const std::size_t digit = other.find_first_of("12345678", other.size() / 3);
    other[digit] = static_cast<char>(other[digit] + 1);
    std::ofstream(run.path() / name, std::ios::trunc) << other;
    CHECK(run.damaged() == Names{name});
    CHECK_THAT(run.told_of(name), Catch::Contains("checkpoint 000010"));
    std::ofstream(run.path() / name, std::ios::trunc) << sound;
  }
}

TEST_CASE("damage of checkpoints alone has its own exit code", "[coupler][cli][verify]") {
  const Run run(Run::End::finished);
  flip(run.path() / "checkpoints" / "000010" / "record.state", 100);
  CHECK(run.damaged() == Names{"checkpoints/000010"});
  CHECK_THAT(run.told_of("checkpoints/000010"), Catch::Contains("record.state"));
  CHECK(verify_command(run.path()) == static_cast<int>(ExitCode::checkpoint_unusable));
}

TEST_CASE("a ledger that does not balance is found without any checksum", "[coupler][cli][verify]") {
  const sample::TemporaryDirectory folder;
  std::ofstream(folder.path() / "lock") << "1\n";
  const std::string header =
      "interval,time,injected,in_place,found,in_fractures,leaked,reset,residual,relative_residual\n";
  const auto told = [&](const std::string& lines) {
    std::ofstream(folder.path() / "ledger.csv", std::ios::trunc) << header << lines;
    for (const Finding& finding : verify_run(folder.path()))
      if (finding.name == "ledger.csv") return finding.text;
    return std::string();
  };
  CHECK_THAT(told("1,0.1,1e-3,2e-6,0,9.02e-4,1e-4,0,0,0\n2,0.2,2e-3,2e-6,0,1.9"),
             Catch::Contains("1 lines balance"));
  CHECK_THAT(told("1,0.1,1e-3,2e-6,0,9.03e-4,1e-4,0,0,0\n"), Catch::Contains("line 2: the volumes leave"));
  CHECK_THAT(told("1,0.1,1e-3,0,0,9e-4,1e-4,0,0,1e-9\n"), Catch::Contains("relative residual is 1e-09"));
  CHECK_THAT(told("1,0.1,0,0,0,0,0,0,0,0\n3,0.2,0,0,0,0,0,0,0,0\n"),
             Catch::Contains("interval 3 after interval 1"));
  CHECK_THAT(told("1,0.1,0,0,0,0,0,0,0,0\n2,0.1,0,0,0,0,0,0,0,0\n"),
             Catch::Contains("time 0.1 s after 0.1 s"));
  CHECK_THAT(told("1,0.1,0,0,0,0,zero,0,0,0\n"), Catch::Contains("\"zero\" is no number"));
}

TEST_CASE("a directory without a run cannot be verified", "[coupler][cli][verify]") {
  const sample::TemporaryDirectory folder;
  CHECK_THROWS_WITH(verify_run(folder.path()), Catch::Contains("holds no run"));
}
