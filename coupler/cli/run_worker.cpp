// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/run_worker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "common/case/case_json.hpp"
#include "common/faults/fault_point.hpp"
#include "common/log.hpp"
#include "coupler/checkpoint/checkpoint_store.hpp"
#include "coupler/cli/epochs.hpp"
#include "coupler/cli/flow_solver_command.hpp"
#include "coupler/cli/going_on.hpp"
#include "coupler/cli/natural_fracture_files.hpp"
#include "coupler/cli/run_command.hpp"
#include "coupler/faults/proxy.hpp"
#include "coupler/launch/trio.hpp"
#include "coupler/record/run_record.hpp"
#include "coupler/scheme/staggered_scheme.hpp"
#include "coupler/seismicity/analysis/analysis_json.hpp"
#include "coupler/tape/tape_recorder.hpp"
#include "coupler/verdict/summary.hpp"
#include "coupler/verdict/verdict_table.hpp"

namespace fissura::coupler {

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char character : text) word += character == '\'' ? "'\\''" : std::string(1, character);
  return word + "'";
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

std::set<Role> taped_roles(const PreparedRun& run) {
  std::set<Role> roles;
  for (const Role role : {Role::structure, Role::network})
    if (std::find(run.tape.begin(), run.tape.end(), name(role)) != run.tape.end()) roles.insert(role);
  return roles;
}

class Worker {
 public:
  Worker(const PreparedRun& run, const Attempt& attempt, StatusPage& status)
      : run_(run),
        attempt_(attempt),
        status_(status),
        store_(run.directory, run.reading.value.checkpoint.keep),
        going_on_(run, attempt, store_),
        record_(run.directory, run.reading.value.output.reports_per_segment),
        monitor_(run.reading.value),
        tapes_(run.directory, taped_roles(run), run.run_id, attempt.epoch),
        trio_(trio_options(), run.run_id, attempt.epoch, status) {}

  int execute() {
    try {
      const std::optional<Checkpoint> checkpoint = going_on_.usable_checkpoint();
      start(checkpoint);
      Checkpointing checkpointing(run_.reading.value, provenance_of(run_, trio_), attempt_.epoch, store_,
                                  trio_, record_, monitor_, status_);
      StaggeredScheme scheme(run_.reading.value, run_.end, trio_, record_, monitor_, checkpointing, status_);
      if (checkpoint)
        scheme.resume(*checkpoint, going_on_.with_another_solver() ? NetworkGoingOn::neutral_state
                                                                   : NetworkGoingOn::own_state);
      else
        scheme.begin();
      going_on_.keep(record_);
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
    } catch (const std::filesystem::filesystem_error& failure) {
      return fail(ExitCode::storage_failure, "coupler", failure.what());
    } catch (const std::bad_alloc&) {
      return fail(ExitCode::out_of_memory, "coupler", "out of memory");
    } catch (const std::exception& failure) {
      return fail(ExitCode::internal, "coupler", failure.what());
    }
  }

 private:
  [[nodiscard]] TrioOptions trio_options() {
    TrioOptions options;
    options.listening = run_.listening;
    for (const auto& [role, command] :
         {std::pair{Role::structure, run_.structure_command}, {Role::network, run_.network_command}})
      if (std::find(run_.awaited.begin(), run_.awaited.end(), name(role)) == run_.awaited.end())
        options.command[static_cast<std::size_t>(role)] = relayed(name(role), command);
    if (run_.keys) options.more_words = " --keys " + shell_word(run_.keys->string());
    if (!run_.tape.empty()) options.observer = &tapes_;
    options.threads = run_.threads;
    options.deadlines = run_.reading.value.deadlines;
    options.debug_attach = run_.debug_attach;
    options.on_warning = [this](Role role, const char* event, const std::string& text) {
      log::warn(text);
      if (recording_) record_.event(EventLevel::warn, name(role), event, text);
    };
    return options;
  }

  /// A participant whose messages the plan spoils is run by a proxy.
  [[nodiscard]] std::string relayed(const std::string& role, const std::string& command) const {
    if (!run_.fault_plan.relays(role)) return command;
    const std::filesystem::path transcript =
        std::filesystem::absolute(run_.directory) / fmt::format("fault_transcript_{}.jsonl", role);
    return behind_proxy(sibling("fault_proxy"), *run_.fault_plan_file, role, transcript, command);
  }

  void start(const std::optional<Checkpoint>& checkpoint) {
    const std::uint64_t interval = checkpoint ? checkpoint->manifest.interval : 0;
    status_.change([&](RunStatus& status) {
      status.epoch = attempt_.epoch;
      status.started_at = monotonic_seconds();
      status.started_time = status.time = checkpoint ? checkpoint->manifest.time : 0;
      status.end = run_.end;
      status.has_checkpoint = checkpoint.has_value();
      status.checkpoint_interval = interval;
      status.checkpoint_time = status.started_time;
    });
    status_.show(interval, checkpoint ? "resume" : "start");
    fault_point(FaultPhase::start, interval);
    note_epoch(run_.directory, attempt_.epoch, checkpoint ? std::optional(interval) : std::nullopt);
    const nlohmann::json run_case = case_to_json(run_.reading.value);
    trio_.start(run_case, checkpoint ? Start::resuming : Start::fresh);
    if (checkpoint) going_on_.require_usable(*checkpoint, trio_);
    const RunDescription description{hexadecimal(run_.run_id),
                                     run_.reading.value.title,
                                     run_case,
                                     run_.reading.files,
                                     run_.command_line,
                                     run_.threads,
                                     provenance_of(run_, trio_).participants,
                                     {},
                                     probe_names(run_.reading.value)};
    if (checkpoint)
      record_.resume(description, checkpoint->states.at("record"));
    else
      record_.begin(description);
    recording_ = true;
    if (checkpoint)
      monitor_.resume(run_.directory / catalogue_folder, hexadecimal(run_.run_id), record_.started(),
                      checkpoint->states.at("seismicity"));
    else
      monitor_.begin(run_.directory / catalogue_folder, hexadecimal(run_.run_id), record_.started());
    note_start(checkpoint);
  }

  void note_start(const std::optional<Checkpoint>& checkpoint) {
    if (attempt_.resumes)
      record_.event(EventLevel::info, "coupler", "resume",
                    checkpoint ? fmt::format("after interval {}, epoch {}", checkpoint->manifest.interval,
                                             attempt_.epoch)
                               : fmt::format("from the beginning, epoch {}", attempt_.epoch));
    if (!trio_.can(Role::structure, "save") || !trio_.can(Role::network, "save"))
      record_.event(EventLevel::warn, "coupler", "checkpoint",
                    "a participant cannot save its state: the run keeps no checkpoints");
    if (checkpoint) return;
    const NaturalFractureReport& natural = run_.reading.natural_fractures;
    if (natural.given + natural.drawn > 0)
      record_.event(EventLevel::info, "coupler", "case", summary_of(natural));
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
    tapes_.sync();
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
  const Attempt& attempt_;
  StatusPage& status_;
  CheckpointStore store_;
  GoingOn going_on_;
  RunRecord record_;
  SeismicMonitor monitor_;
  TapeRecorder tapes_;
  Trio trio_;
  RunFigures figures_;
  bool recording_ = false;  ///< run.json and the tables exist
};

}  // namespace

int run_worker(const PreparedRun& run, const Attempt& attempt, StatusPage& status) {
  log::start("coupler");
  try {
    ::setenv("FISSURA_EPOCH", std::to_string(attempt.epoch).c_str(), 1);
    arm_planned_faults("coupler");
    return Worker(run, attempt, status).execute();
  } catch (const Error& failure) {
    status.fail(failure_of(failure.code(), "coupler", 0, "start", failure.what()));
    return static_cast<int>(failure.code());
  } catch (const std::filesystem::filesystem_error& failure) {
    status.fail(failure_of(ExitCode::storage_failure, "coupler", 0, "start", failure.what()));
    return static_cast<int>(ExitCode::storage_failure);
  } catch (const std::exception& failure) {
    status.fail(failure_of(ExitCode::internal, "coupler", 0, "start", failure.what()));
    return static_cast<int>(ExitCode::internal);
  }
}

}  // namespace fissura::coupler
