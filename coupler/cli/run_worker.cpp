// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/run_worker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "common/case/case_json.hpp"
#include "common/faults/fault_point.hpp"
#include "common/log.hpp"
#include "coupler/cli/natural_fracture_files.hpp"
#include "coupler/launch/supervisor.hpp"
#include "coupler/launch/trio.hpp"
#include "coupler/record/run_record.hpp"
#include "coupler/scheme/staggered_scheme.hpp"
#include "coupler/seismicity/analysis/analysis_json.hpp"
#include "coupler/verdict/summary.hpp"
#include "coupler/verdict/verdict_table.hpp"

namespace fissura::coupler {

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

RunId random_run_id() {
  std::random_device source;
  RunId run;
  for (std::uint8_t& byte : run) byte = static_cast<std::uint8_t>(source());
  return run;
}

std::string hexadecimal(const RunId& run) {
  std::string text;
  for (const std::uint8_t byte : run) text += fmt::format("{:02x}", byte);
  return text;
}

/// A path for the socket that the system accepts: its address holds about a hundred characters.
class SocketPlace {
 public:
  explicit SocketPlace(const std::filesystem::path& run_directory) {
    constexpr std::size_t longest_address = 100;
    path_ = std::filesystem::absolute(run_directory / "coupler.ipc");
    if (path_.string().size() <= longest_address) return;
    std::string pattern = (std::filesystem::temp_directory_path() / "fissura-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw Error(ExitCode::precondition, "cannot create " + pattern);
    temporary_ = pattern;
    path_ = temporary_ / "coupler.ipc";
  }
  ~SocketPlace() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
    if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
  }
  SocketPlace(const SocketPlace&) = delete;
  SocketPlace& operator=(const SocketPlace&) = delete;
  [[nodiscard]] std::string endpoint() const { return "ipc://" + path_.string(); }

 private:
  std::filesystem::path path_, temporary_;
};

std::string solver_of(const Trio& trio, Role role) {
  const ParticipantIdentity& identity = trio.identity(role);
  return identity.solver + " " + identity.version;
}

RunFailure failure_of(ExitCode code, const char* who, std::uint64_t interval, const std::string& phase,
                      const std::string& sentence) {
  RunFailure failure;
  failure.exit_code = static_cast<int>(code);
  failure.who = who;
  failure.interval = interval;
  failure.phase = phase;
  failure.sentence = sentence;
  return failure;
}

class Worker {
 public:
  Worker(const PreparedRun& run, StatusPage& status)
      : run_(run),
        status_(status),
        record_(run.directory, run.reading.value.output.reports_per_segment),
        monitor_(run.reading.value),
        socket_(run.directory),
        run_id_(random_run_id()),
        trio_(trio_options(), run_id_, 0, status) {}

  int execute() {
    try {
      start();
      StaggeredScheme scheme(run_.reading.value, run_.end, trio_, record_, monitor_, status_);
      const SchemeOutcome outcome = scheme.run();
      figures_.insertions = outcome.insertions;
      monitor_.conclude();
      status_.show(record_.history().size(), "finish");
      fault_point(FaultPhase::finish, record_.history().size());
      take_figures(trio_.finish());
      return conclude(outcome.stop_signal);
    } catch (const ParticipantFailure& failure) {
      return fail(failure.code(), name(failure.role), failure.what());
    } catch (const Error& failure) {
      return fail(failure.code(), "coupler", failure.what());
    } catch (const std::bad_alloc&) {
      return fail(ExitCode::out_of_memory, "coupler", "out of memory");
    } catch (const std::exception& failure) {
      return fail(ExitCode::internal, "coupler", failure.what());
    }
  }

 private:
  [[nodiscard]] TrioOptions trio_options() const {
    const Case& run_case = run_.reading.value;
    return {run_case.exchange.endpoint == "ipc" ? socket_.endpoint() : run_case.exchange.endpoint,
            {run_.structure_command, run_.network_command},
            run_.threads,
            run_case.deadlines};
  }

  void start() {
    status_.show(0, "start");
    fault_point(FaultPhase::start, 0);
    const nlohmann::json run_case = case_to_json(run_.reading.value);
    trio_.start(run_case, Start::fresh);
    record_.begin(
        {hexadecimal(run_id_),
         run_.reading.value.title,
         run_case,
         run_.reading.files,
         run_.command_line,
         run_.threads,
         {{"structure", solver_of(trio_, Role::structure)}, {"network", solver_of(trio_, Role::network)}},
         {},
         probe_names(run_.reading.value)});
    recording_ = true;
    monitor_.begin(run_.directory / "seismicity", hexadecimal(run_id_), record_.started());
    const NaturalFractureReport& natural = run_.reading.natural_fractures;
    if (natural.given + natural.drawn > 0)
      record_.event(EventLevel::info, "coupler", "case", summary_of(natural));
    write_natural_fractures(run_.directory, run_.reading.value, natural);
    for (const Fault& warning : run_.reading.warnings)
      record_.event(EventLevel::warn, "coupler", "case", describe(warning));
  }

  void take_figures(const std::array<nlohmann::json, 2>& figures) {
    const nlohmann::json& structure = figures[static_cast<std::size_t>(Role::structure)];
    figures_.elements = structure.value("elements", std::uint64_t{0});
    figures_.nodes = structure.value("nodes", std::uint64_t{0});
    figures_.slip_before_time_0 = structure.value("equilibration_slip", 0.0);
    figures_.wall.element = structure.value("element_seconds", 0.0);
    figures_.wall.joint = structure.value("joint_seconds", 0.0);
    figures_.wall.structure = structure.value("work_seconds", 0.0);
    figures_.wall.network = figures[static_cast<std::size_t>(Role::network)].value("work_seconds", 0.0);
  }

  /// While the coupler waits for an answer, either that participant is at work or a message is on its way.
  nlohmann::ordered_json summary(const Verdict& verdict) {
    WallTimes& wall = figures_.wall;
    wall.total = since(start_);
    const double waited = trio_.waited(Role::structure) + trio_.waited(Role::network);
    wall.coupler = wall.total - waited;
    figures_.remeshing = record_.remesh_totals();
    figures_.meetings = record_.meeting_totals();
    figures_.seismicity = monitor_.summary();
    wall.seismicity = monitor_.wall_seconds();
    wall.waiting = std::max(0.0, waited - wall.structure - wall.network);
    return summary_json(verdict, record_.history(), figures_);
  }

  /// What the catalogue says about the run.
  [[nodiscard]] nlohmann::json analysis() const {
    const auto time = record_.history().series("time").value(),
               volume = record_.history().series("injected").value();
    const InjectedVolume injected{{time.begin(), time.end()}, {volume.begin(), volume.end()}};
    return analysis_json(monitor_.events(), run_.reading.value, injected, monitor_.sums());
  }

  int conclude(int stop_signal) {
    record_.close();
    monitor_.finish(analysis());
    const Verdict verdict = stop_signal == 0 ? judge(run_.expectations, record_.history()) : Verdict{};
    const nlohmann::ordered_json figures = summary(verdict);
    record_.finish(figures);
    if (run_.json)
      std::printf("%s\n", figures.dump(2).c_str());
    else
      std::printf("%sresults: %s\n", verdict_table(verdict).c_str(), run_.directory.string().c_str());
    if (stop_signal != 0) return 128 + stop_signal;
    return static_cast<int>(verdict.judgement == Judgement::fail ? ExitCode::verdict_failed : ExitCode::done);
  }

  /// All events so far stay in catalogue.csv. That this fails must not hide the failure being told of.
  void keep_events() {
    try {
      monitor_.conclude();
      monitor_.flush();
    } catch (const std::exception& second) {
      log::error(fmt::format("the catalogue could not be closed: {}", second.what()));
    }
  }

  int fail(ExitCode code, const char* who, const std::string& sentence) {
    const std::uint64_t interval = status_.interval();
    const std::string phase = status_.phase();
    status_.fail(failure_of(code, who, interval, phase, sentence));
    trio_.abort(sentence);
    figures_.failure = Failure{code, who, interval, phase, sentence};
    keep_events();
    try {
      if (recording_) record_.event(EventLevel::error, who, "failure", sentence);
      record_.finish(summary(Verdict{}));
    } catch (const std::exception& second) {
      log::error(fmt::format("the record could not be closed: {}", second.what()));
    }
    return static_cast<int>(code);
  }

  Clock::time_point start_ = Clock::now();
  const PreparedRun& run_;
  StatusPage& status_;
  RunRecord record_;
  SeismicMonitor monitor_;
  SocketPlace socket_;
  RunId run_id_;
  Trio trio_;
  RunFigures figures_;
  bool recording_ = false;  ///< run.json and the tables exist
};

}  // namespace

int run_worker(const PreparedRun& run, StatusPage& status) {
  log::start("coupler");
  try {
    arm_planned_faults("coupler");
    return Worker(run, status).execute();
  } catch (const Error& failure) {
    status.fail(failure_of(failure.code(), "coupler", 0, "start", failure.what()));
    return static_cast<int>(failure.code());
  } catch (const std::exception& failure) {
    status.fail(failure_of(ExitCode::internal, "coupler", 0, "start", failure.what()));
    return static_cast<int>(ExitCode::internal);
  }
}

}  // namespace fissura::coupler
