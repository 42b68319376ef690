// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/run_state.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "common/errors.hpp"
#include "coupler/record/run_directory.hpp"
#include "tests/coupler/temporary_directory.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

/// A fifth of the way in ten seconds, with the network at work.
RunState running() {
  const double now = monotonic_seconds();
  RunStatus status;
  status.interval = 42;
  status.phase = "network";
  status.phase_since = now - 0.5;
  status.started_at = now - 10;
  status.time = 2;
  status.end = 10;
  status.participants[0].asked = "ADVANCE";
  status.participants[0].last_word = now - 0.6;
  status.participants[0].pid = ::getpid();
  ParticipantStatus& network = status.participants[1];
  network.asked = "ADVANCE";
  network.interval = 42;
  network.asked_at = now - 0.5;
  network.last_word = now - 0.4;
  network.phase = "newton";
  network.count = 34;
  network.is_waited_for = true;
  return {"/runs/kgd", 123, status, {}, 40};
}

}  // namespace

TEST_CASE("a run that goes on tells who waits for whom, since when and on what", "[coupler][cli]") {
  const nlohmann::ordered_json found = run_state_json(running());
  CHECK(found["state"] == "running");
  CHECK(found["pid"] == 123);
  CHECK(found["waits_for"] == nlohmann::json{"network"});
  CHECK(found["participants"]["network"]["phase"] == "newton");
  CHECK(found["participants"]["network"]["count"] == 34);
  CHECK(found["participants"]["network"]["process"] == "elsewhere");
  CHECK(found["participants"]["structure"]["process"] == "alive");
  CHECK(found["participants"]["network"]["asked_seconds"].get<double>() == Approx(0.5).margin(0.3));
  CHECK(found["checkpoint"] == 40);
  const std::string text = run_state_text(running());
  for (const char* words : {"waits for network", "at ADVANCE of interval 42", "phase newton, loop count 34",
                            "interval 40", "2 of 10 s (20.0 %)"})
    CHECK_THAT(text, Catch::Contains(words));
}

TEST_CASE("the time left follows from what this life of the run has done", "[coupler][cli]") {
  // 8 of 10 s are left; 2 s took 10.
  CHECK(run_state_json(running())["wall_seconds_left"].get<double>() == Approx(40).epsilon(0.05));
  RunState resumed = running();
  resumed.status->started_time = 1;
  CHECK(run_state_json(resumed)["wall_seconds_left"].get<double>() == Approx(80).epsilon(0.05));
  resumed.status->started_time = 2;
  CHECK(run_state_json(resumed)["wall_seconds_left"].is_null());
}

TEST_CASE("a run that ended without a report was killed, and can be resumed", "[coupler][cli]") {
  RunState state = running();
  state.supervisor.reset();
  const nlohmann::ordered_json found = run_state_json(state);
  CHECK(found["state"] == "killed");
  CHECK(found["resume"] == "coupler resume /runs/kgd");
  CHECK_FALSE(found.contains("waits_for"));
  CHECK_THAT(run_state_text(state),
             Catch::Contains("left no report") && Catch::Contains("(from interval 40)"));
}

TEST_CASE("a run that ended tells what its report says", "[coupler][cli]") {
  RunState state = running();
  state.supervisor.reset();
  state.report = {{"code", 20}, {"name", "PARTICIPANT-DIED"}, {"last_line", "coupler: PARTICIPANT-DIED ..."}};
  CHECK(run_state_json(state)["state"] == "ended");
  CHECK(run_state_json(state)["report"] == state.report);
  CHECK_THAT(run_state_text(state),
             Catch::Contains("20 PARTICIPANT-DIED") && Catch::Contains("coupler: PART"));
}

TEST_CASE("the state of a run is read from its directory, also of one that has only begun",
          "[coupler][cli]") {
  const sample::TemporaryDirectory folder;
  CHECK_THROWS_WITH(read_run_state(folder.path()), Catch::Contains("is not a run directory"));
  CHECK_THROWS_WITH(read_run_state(folder.path() / "none"), Catch::Contains("does not exist"));
  const auto path = folder.path() / "run";
  {
    const RunDirectory directory(path);
    const RunState begun = read_run_state(path);
    CHECK(begun.supervisor == ::getpid());
    CHECK_FALSE(begun.status.has_value());
    CHECK_THAT(run_state_text(begun), Catch::Contains("starting"));
  }
  CHECK_FALSE(read_run_state(path).supervisor.has_value());
}

TEST_CASE("a damaged page or report is not taken for the run's word", "[coupler][cli]") {
  const sample::TemporaryDirectory folder;
  const auto path = folder.path() / "run";
  { const RunDirectory directory(path); }
  std::ofstream(path / "status") << std::string(100000, 'x');
  std::ofstream(path / "run.report.json") << "{\"code\": 2";
  const RunState state = read_run_state(path);
  CHECK_FALSE(state.status.has_value());
  CHECK_FALSE(state.report.is_object());
}
