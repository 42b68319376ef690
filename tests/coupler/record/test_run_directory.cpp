// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "common/errors.hpp"
#include "coupler/record/run_directory.hpp"
#include "tests/coupler/record/sample_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

ExitCode code_of_claiming(const std::filesystem::path& directory) {
  try {
    const RunDirectory claimed(directory);
  } catch (const Error& error) {
    return error.code();
  }
  return ExitCode::done;
}

void touch(const std::filesystem::path& file) {
  std::ofstream(file) << "x";
}

}  // namespace

TEST_CASE("a run directory is created with its parents and for the owner alone", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  const auto path = folder.path() / "runs" / "first";
  const RunDirectory directory(path);
  struct stat status {};
  REQUIRE(::stat(path.c_str(), &status) == 0);
  CHECK((status.st_mode & 0777) == 0700);
}

TEST_CASE("checking a run directory creates nothing", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  RunDirectory::check(folder.path() / "runs" / "first");
  RunDirectory::check(folder.path());
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("two runs cannot share a directory, and the second learns who holds it", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  const RunDirectory first(folder.path());
  const std::string holder = "pid " + std::to_string(::getpid());
  CHECK(code_of_claiming(folder.path()) == ExitCode::role_taken);
  CHECK_THROWS_WITH(RunDirectory(folder.path()), Catch::Contains(holder));
  CHECK_THROWS_WITH(RunDirectory::check(folder.path()), Catch::Contains(holder));
}

TEST_CASE("the lock of a run that was killed is free again", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const RunDirectory directory(folder.path());
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  REQUIRE(WIFSIGNALED(status));
  CHECK(code_of_claiming(folder.path()) == ExitCode::done);
}

TEST_CASE("results are not overwritten unless they are those of a finished run", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  SECTION("foreign files") {
    touch(folder.path() / "thesis.tex");
    CHECK(code_of_claiming(folder.path()) == ExitCode::precondition);
    CHECK(std::filesystem::exists(folder.path() / "thesis.tex"));
    CHECK_FALSE(std::filesystem::exists(folder.path() / "lock"));
  }
  SECTION("a run that did not finish") {
    touch(folder.path() / "run.json");
    CHECK(code_of_claiming(folder.path()) == ExitCode::precondition);
    CHECK_THROWS_WITH(RunDirectory(folder.path()),
                      Catch::Contains("did not finish") && Catch::Contains("--out"));
  }
  SECTION("a run that died before it had written what it is") {
    touch(folder.path() / "lock");
    touch(folder.path() / "coupler.ipc");
    CHECK_THROWS_WITH(RunDirectory(folder.path()), Catch::Contains("did not finish"));
  }
  SECTION("a finished run, with a file of the user in it") {
    for (const char* name : {"run.json", "summary.json", "history.csv", "notes.txt"})
      touch(folder.path() / name);
    std::filesystem::create_directories(folder.path() / "segments");
    touch(folder.path() / "segments" / "000001.h5");
    CHECK(code_of_claiming(folder.path()) == ExitCode::done);
    CHECK_FALSE(std::filesystem::exists(folder.path() / "summary.json"));
    CHECK_FALSE(std::filesystem::exists(folder.path() / "segments"));
    CHECK(std::filesystem::exists(folder.path() / "notes.txt"));
  }
}

TEST_CASE("a path that cannot be a run directory is refused with a reason", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  touch(folder.path() / "file");
  CHECK(code_of_claiming(folder.path() / "file") == ExitCode::precondition);
  CHECK_THROWS_WITH(RunDirectory(folder.path() / "file"), Catch::Contains("not a directory"));
  CHECK(code_of_claiming(folder.path() / "file" / "below") == ExitCode::precondition);
  CHECK(code_of_claiming("/proc/fissura") == ExitCode::precondition);
}
