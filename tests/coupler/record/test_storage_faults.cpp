// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/file.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "common/hash.hpp"
#include "coupler/record/hdf5_file.hpp"
#include "coupler/record/run_record.hpp"
#include "tests/coupler/record/sample_run.hpp"
#include "tests/coupler/record/scripted_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

constexpr int other_failure = 99;
constexpr std::uint64_t many_nodes = 20'000;

/// Exit code of `work` in a child process: 0, that of the Error it threw, or `other_failure`.
int run_in_child(const std::function<void()>& work, int& signal) {
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    int code = 0;
    try {
      work();
    } catch (const Error& error) {
      code = static_cast<int>(error.code());
    } catch (...) {
      code = other_failure;
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Field reports without end, two in a segment, the meshes growing so that segments do too.
void record_without_end(const std::filesystem::path& directory, std::uint64_t nodes_per_report) {
  RunRecord record(directory, 2);
  record.begin({});
  const FractureNetwork network = sample::network();
  for (std::uint64_t number = 1;; ++number) {
    const double time = double(number);
    record.interval(sample::interval(number, time), {});
    record.fields(time, sample::structure_fields(time, number, nodes_per_report * number),
                  sample::network_fields(network), network, sample::node_fields(network, time));
  }
}

/// Reads every report of every segment in the index; returns their number.
int read_all_closed_reports(const std::filesystem::path& directory) {
  int reports = 0;
  for (const std::string& line : sample::lines(directory / "segments" / "index.jsonl")) {
    const auto entry = nlohmann::json::parse(line);
    const auto path = directory / "segments" / entry["file"].get<std::string>();
    CHECK(sha256_of_file(path) == entry["sha256"]);
    const Hdf5File file = Hdf5File::open(path);
    for (std::uint64_t number = entry["reports"][0]; number <= entry["reports"][1]; ++number, ++reports) {
      char dataset[64];
      std::snprintf(dataset, sizeof(dataset), "/reports/%06d/structure/displacement",
                    static_cast<int>(number));
      CHECK(sample::doubles(file.read(dataset)).at(3) == 1.0 + double(number));
    }
  }
  return reports;
}

}  // namespace

TEST_CASE("a limit on the file size is a storage error, and closed segments stay readable",
          "[coupler][record][faults]") {
  const sample::TemporaryDirectory folder;
  int signal = 0;
  const int code = run_in_child(
      [&] {
        const rlimit limit{4 << 20, 4 << 20};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        record_without_end(folder.path(), many_nodes / 10);
      },
      signal);
  CHECK(signal == 0);
  CHECK(code == static_cast<int>(ExitCode::storage_failure));
  CHECK(read_all_closed_reports(folder.path()) >= 2);
}

TEST_CASE("a full disk is a storage error, and closed segments stay readable", "[coupler][record][faults]") {
  const sample::TemporaryDirectory folder;
  if (::mount("tmpfs", folder.path().c_str(), "tmpfs", 0, "size=4m,mode=0700") != 0) {
    WARN("skipped: no right to mount a small tmpfs here");
    return;
  }
  int signal = 0;
  const int code = run_in_child([&] { record_without_end(folder.path(), many_nodes / 100); }, signal);
  CHECK(signal == 0);
  CHECK(code == static_cast<int>(ExitCode::storage_failure));
  CHECK(read_all_closed_reports(folder.path()) >= 2);
  CHECK(::umount2(folder.path().c_str(), MNT_DETACH) == 0);
}

TEST_CASE("a run killed in mid-segment leaves its closed segments readable and nothing half written",
          "[coupler][record][faults]") {
  const sample::TemporaryDirectory folder;
  int signal = 0;
  run_in_child(
      [&] {
        RunRecord record(folder.path(), 2);
        record.begin({});
        const FractureNetwork network = sample::network();
        for (int number = 1; number <= 5; ++number)
          record.fields(number, sample::structure_fields(number, 0, many_nodes),
                        sample::network_fields(network), network, sample::node_fields(network, number));
        ::kill(::getpid(), SIGKILL);
      },
      signal);
  CHECK(signal == SIGKILL);
  CHECK(read_all_closed_reports(folder.path()) == 4);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "segments" / "000003.h5.part"));
  CHECK(sample::content(folder.path() / "fields.xdmf").find("000003.h5") == std::string::npos);
}

TEST_CASE("after a storage failure the run can still write its summary once there is room",
          "[coupler][record][faults]") {
  const sample::TemporaryDirectory folder;
  int signal = 0;
  const int code = run_in_child(
      [&] {
        RunRecord record(folder.path(), 1);
        record.begin({});
        const FractureNetwork network = sample::network();
        const rlimit limit{1 << 18, RLIM_INFINITY};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        bool failed = false;
        try {
          record.fields(1, sample::structure_fields(1, 0, many_nodes), sample::network_fields(network),
                        network, sample::node_fields(network, 1));
        } catch (const StorageError&) {
          failed = true;
        }
        record.finish({{"verdict", "fail"}});
        if (!failed) throw std::runtime_error("no storage error");
      },
      signal);
  CHECK(code == 0);
  CHECK(nlohmann::json::parse(sample::content(folder.path() / "summary.json"))["verdict"] == "fail");
  CHECK_FALSE(std::filesystem::exists(folder.path() / "segments" / "000001.h5.part"));
}

TEST_CASE("a run directory that is deleted during the run is a storage error, and is not made again",
          "[coupler][record][faults]") {
  const sample::TemporaryDirectory folder;
  const auto directory = folder.path() / "run";
  std::filesystem::create_directory(directory);
  RunRecord record(directory, sample::reports_per_segment);
  record.begin(sample::description());
  const std::uint64_t before = GENERATE(1, 7);
  sample::record_intervals(record, 1, before);
  std::filesystem::remove_all(directory);
  SECTION("found by the next segment") {
    CHECK_THROWS_AS(sample::record_intervals(record, before + 1, before + 6), StorageError);
  }
  SECTION("found by the next checkpoint") {
    CHECK_THROWS_AS(record.save(), StorageError);
  }
  CHECK_FALSE(std::filesystem::exists(directory));
}

TEST_CASE("a table that is removed during the run is found at the next checkpoint",
          "[coupler][record][faults]") {
  const sample::TemporaryDirectory folder;
  RunRecord record(folder.path(), sample::reports_per_segment);
  record.begin(sample::description());
  sample::record_intervals(record, 1, 6);
  std::filesystem::remove(folder.path() / "ledger.csv");
  CHECK_THROWS_WITH(record.save(), Catch::Contains("ledger.csv was removed"));
}

TEST_CASE("a lock that somebody holds on a segment does not keep the library from reading or writing",
          "[coupler][record][faults]") {
  const sample::TemporaryDirectory folder;
  sample::record_run(folder.path(), 8);
  const auto segment = folder.path() / "segments" / "000001.h5";
  const int descriptor = ::open(segment.c_str(), O_RDONLY);
  REQUIRE(::flock(descriptor, LOCK_EX | LOCK_NB) == 0);
  CHECK_NOTHROW(Hdf5File::open(segment).datasets());
  CHECK_NOTHROW(Hdf5File::create(segment));
  ::close(descriptor);
}
