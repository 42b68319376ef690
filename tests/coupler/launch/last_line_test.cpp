// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/last_line.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "tests/coupler/launch/failure.hpp"
#include "tests/coupler/temporary_directory.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

void make_checkpoint(const std::filesystem::path& run, const char* folder) {
  std::filesystem::create_directories(run / "checkpoints" / folder);
  std::ofstream(run / "checkpoints" / folder / "MANIFEST.json") << "{}";
}

}  // namespace

TEST_CASE("the last line names code, who, interval, phase, cause and how to go on", "[coupler][launch]") {
  const RunFailure failure = sample::failure(ExitCode::participant_died, "network", 17, "network was killed");
  CHECK(last_line(failure, "/runs/kgd", 12) ==
        "coupler: PARTICIPANT-DIED network interval=17 phase=network: network was killed. Resume: coupler "
        "resume "
        "/runs/kgd (from interval 12)");
  CHECK(last_line(failure, "/runs/kgd", std::nullopt) ==
        "coupler: PARTICIPANT-DIED network interval=17 phase=network: network was killed. Resume: coupler "
        "resume "
        "/runs/kgd (from the beginning)");
}

TEST_CASE("nobody is told to resume what something else must mend first", "[coupler][launch]") {
  for (const ExitCode code : {ExitCode::case_invalid, ExitCode::precondition, ExitCode::role_taken,
                              ExitCode::mismatch, ExitCode::security, ExitCode::command_line}) {
    const RunFailure failure = sample::failure(code, "network", 0, "network was refused");
    CHECK(last_line(failure, "/runs/kgd", 12) == last_line(failure));
  }
  CHECK_FALSE(can_resume_after(0));
  CHECK_FALSE(can_resume_after(1));
  for (const int code : {20, 21, 22, 23, 24, 25, 26, 27, 70, 129, 130, 143}) CHECK(can_resume_after(code));
}

TEST_CASE("the last line is one line, whatever the cause holds, and the command survives a shell",
          "[coupler][launch]") {
  const RunFailure failure = sample::failure(ExitCode::internal, "coupler", 1, "first\nsecond.\n");
  CHECK(last_line(failure, "/my runs/it's", 1) ==
        "coupler: INTERNAL coupler interval=1 phase=network: first second. Resume: coupler resume '/my "
        "runs/it'\\''s' (from interval 1)");
}

TEST_CASE("every end by a signal has a name", "[coupler][launch]") {
  CHECK(name_of_code(129) == "HANGUP");
  CHECK(name_of_code(130) == "INTERRUPTED");
  CHECK(name_of_code(143) == "TERMINATED");
}

TEST_CASE("only a checkpoint that was completed counts", "[coupler][launch]") {
  const sample::TemporaryDirectory run;
  CHECK_FALSE(newest_checkpoint(run.path()).has_value());
  make_checkpoint(run.path(), "000009");
  make_checkpoint(run.path(), "000010");
  make_checkpoint(run.path(), "000011.part");
  std::filesystem::create_directories(run.path() / "checkpoints" / "other");
  CHECK(newest_checkpoint(run.path()) == 10u);
}
