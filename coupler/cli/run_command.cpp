// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/run_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <set>
#include <thread>

#include "common/case/units.hpp"
#include "common/exchange/debugger.hpp"
#include "common/exchange/participant.hpp"
#include "common/faults/process_fault.hpp"
#include "coupler/cli/epochs.hpp"
#include "coupler/cli/flow_solver_command.hpp"
#include "coupler/cli/natural_fracture_files.hpp"
#include "coupler/cli/run_worker.hpp"
#include "coupler/launch/machine_check.hpp"
#include "coupler/launch/message_bound.hpp"
#include "coupler/launch/secure_endpoint.hpp"
#include "coupler/launch/socket_place.hpp"
#include "coupler/launch/supervisor.hpp"
#include "coupler/record/run_directory.hpp"
#include "coupler/verdict/verdict.hpp"

namespace fissura::coupler {

namespace {

std::filesystem::path default_directory(const CaseReading& reading,
                                        const std::vector<std::string>& variants) {
  std::string name = std::filesystem::absolute(reading.folder).lexically_normal().filename().string();
  for (const std::string& variant : variants) name += "-" + variant;
  return std::filesystem::path("runs") / name;
}

/// Reads what the run must give, and enters the files that say so among those of the case.
Expectations expectations_of(CaseReading& reading, const std::vector<std::string>& variants) {
  std::string name = "expected";
  for (const std::string& variant : variants) name += "_" + variant;
  const std::filesystem::path file = reading.folder / (name + ".toml");
  if (!std::filesystem::exists(file)) return {};
  const Expectations expectations =
      read_expectations(file, reading.value.time.end, judgeable_columns(probe_names(reading.value)));
  check_references(expectations);
  std::set<std::filesystem::path> files{file};
  for (const ExpectedQuantity& quantity : expectations.quantities)
    if (!quantity.reference.empty()) files.insert(quantity.reference);
  reading.files.insert(reading.files.end(), files.begin(), files.end());
  return expectations;
}

double end_of_run(const RunOptions& options, const Case& run_case) {
  if (!options.until) return run_case.time.end;
  const double until = input::in_si(*options.until, input::dimension::time);
  if (!(until > 0 && until <= run_case.time.end))
    throw Error(ExitCode::command_line,
                fmt::format("--until {}: expected a time in (0, {}] s", *options.until, run_case.time.end));
  return until;
}

/// Every process of the run finds its part of the plan in the environment.
void announce_faults(const std::optional<std::string>& fault, const PreparedRun& run) {
  if (fault) {
    std::fprintf(stderr, "warning: a fault will be injected: %s\n", fault->c_str());
    ::setenv("FISSURA_FAULT", fault->c_str(), 1);
  }
  if (run.fault_plan_file) {
    std::fprintf(
        stderr, "warning: faults will be injected: %zu in processes and %zu in messages, as %s says\n",
        run.fault_plan.processes.size(), run.fault_plan.messages.size(), run.fault_plan_file->c_str());
    ::setenv("FISSURA_FAULT_PLAN", run.fault_plan_file->c_str(), 1);
  }
}

void read_faults(const std::optional<std::string>& fault, const std::optional<std::filesystem::path>& plan,
                 PreparedRun& run) {
  if (fault) (void)parse_process_fault(*fault);
  if (!plan) return;
  run.fault_plan = read_fault_plan(*plan);
  run.fault_plan_file = std::filesystem::absolute(*plan);
}

/// Where the participants of `run` connect, and with which keys. Throws Error(security) if keys are needed
/// and there are none, or some cannot be used.
void open_door(PreparedRun& run) {
  const Case& run_case = run.reading.value;
  run.listening.endpoint = run_case.exchange.endpoint;
  run.listening.largest_frame = largest_frame(run_case);
  require_keys(run.listening.endpoint, run.keys ? Keys::present : Keys::absent);
  raise_limit_of_open_files();
  if (!run.keys) return;
  if (!run.fault_plan.messages.empty())
    throw Error(ExitCode::command_line,
                "a plan cannot spoil messages that keys protect: leave out --keys or those faults");
  run.listening.keys = read_coupler_keys(*run.keys);
  for (const Role role : {Role::structure, Role::network})
    if (std::find(run.awaited.begin(), run.awaited.end(), name(role)) == run.awaited.end())
      (void)read_participant_keys(*run.keys, name(role));
}

/// Runs under a supervisor that holds the run directory.
int supervised(const PreparedRun& prepared, const Attempt& first, bool heals) {
  PreparedRun run = prepared;
  // Threads of the structure that wait for each other long would keep the other two processes from the cores.
  ::setenv("GOMP_SPINCOUNT", "1000", 0);
  if (run.debug_attach) announce_debugger();
  const SocketPlace socket(run.directory);
  if (run.listening.endpoint == "ipc") run.listening.endpoint = socket.endpoint();
  StatusPage status(run.directory / "status");
  constexpr double no_deadline = std::numeric_limits<double>::infinity();
  const double deadline = run.debug_attach ? no_deadline : run.reading.value.deadlines.progress;
  Supervision supervision{run.directory, deadline, {}, first};
  supervision.healing.wanted = heals;
  return supervise(status, supervision,
                   [&](const Attempt& attempt) { return run_worker(run, attempt, status); });
}

/// Another flow solver is to go on from epoch `epoch` on. It is started here, whoever started the one before.
void change_network(const std::string& words, std::uint32_t epoch, PreparedRun& run) {
  const std::string command = flow_solver_command(words);
  const auto was_awaited = std::erase(run.awaited, name(Role::network));
  if (command == run.network_command && was_awaited == 0) return;
  run.network_command = command;
  run.network_since = epoch;
}

}  // namespace

std::vector<std::string> probe_names(const Case& run_case) {
  std::vector<std::string> names;
  for (const Probe& probe : run_case.output.probes) names.push_back(probe.name);
  return names;
}

PreparedRun prepare_run(const RunOptions& options) {
  require_descriptors();
  PreparedRun run;
  read_faults(options.fault, options.fault_plan, run);
  run.reading = read_case(options.source);
  run.end = end_of_run(options, run.reading.value);
  const Expectations expectations = expectations_of(run.reading, options.source.variants);
  // A run that is cut short cannot be judged by what it should give at its end.
  if (!options.until) run.expectations = expectations;
  run.directory = options.directory.value_or(default_directory(run.reading, options.source.variants));
  RunDirectory::check(run.directory);
  run.structure_command = options.structure_command.value_or(sibling("structure"));
  run.network_command =
      flow_solver_command(options.network_command.value_or(run.reading.value.participants.network));
  if (options.keys) run.keys = std::filesystem::absolute(*options.keys);
  run.awaited = options.awaited;
  run.tape = options.tape;
  run.threads = options.threads > 0 ? options.threads
                                    : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  run.json = options.json;
  run.debug_attach = options.debug_attach;
  run.command_line = options.command_line;
  run.run_id = random_run_id();
  return run;
}

int run_command(const RunOptions& options) {
  PreparedRun run = prepare_run(options);
  open_door(run);
  for (const Fault& warning : run.reading.warnings)
    std::fprintf(stderr, "warning: %s\n", describe(warning).c_str());
  const RunDirectory directory(run.directory);
  run.directory = directory.path();
  write_natural_fractures(run.directory, run.reading.value, run.reading.natural_fractures);
  write_resume_file(run);
  announce_faults(options.fault, run);
  return supervised(run, {false, 0}, options.heal);
}

int resume_command(const ResumeOptions& options) {
  require_descriptors();
  PreparedRun run = read_resume_file(options.directory);
  const RunDirectory directory(run.directory, RunDirectory::Use::resumption);
  run.directory = directory.path();
  if (options.threads > 0) run.threads = options.threads;
  run.json = run.json || options.json;
  if (!options.tape.empty()) run.tape = options.tape;
  const std::uint32_t epoch = epochs_so_far(run.directory);
  if (options.network_command) change_network(*options.network_command, epoch, run);
  read_faults(options.fault, options.fault_plan, run);
  announce_faults(options.fault, run);
  open_door(run);
  return supervised(run, {true, epoch}, options.heal);
}

}  // namespace fissura::coupler
