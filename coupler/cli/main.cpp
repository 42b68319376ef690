// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "common/errors.hpp"
#include "common/log.hpp"
#include "coupler/cli/check_command.hpp"
#include "coupler/cli/conform_command.hpp"
#include "coupler/cli/keys_command.hpp"
#include "coupler/cli/replay_command.hpp"
#include "coupler/cli/report_command.hpp"
#include "coupler/cli/run_command.hpp"
#include "coupler/cli/seismicity_command.hpp"
#include "coupler/cli/status_command.hpp"
#include "coupler/cli/stop_command.hpp"
#include "coupler/cli/verify_command.hpp"

namespace {

using fissura::CaseSource;
using fissura::ExitCode;
using fissura::coupler::StatusForm;
using fissura::coupler::StopTime;

void add_case_options(CLI::App& command, CaseSource& source, bool& short_form) {
  command.add_option("CASE", source.path, "case folder, or its case.toml")->required();
  command.add_option("--set", source.overrides, "another value for a key, e.g. mesh.fracture_size=\"0.5 m\"")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--variant", source.variants, "lays NAME.toml of the case folder over case.toml")
      ->type_name("NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_flag("--short", short_form, "the short form: --variant short, after any other");
}

void add_seismicity_options(CLI::App& command, fissura::coupler::SeismicityOptions& options) {
  command.add_option("RUN", options.run_directory, "run directory; the run may have failed")->required();
  command.add_option("--cluster-radius", options.cluster_radius, "sources farther apart are two events");
  command.add_option("--cluster-time", options.cluster_time, "likewise, in time");
  command.add_option("--rest-time", options.rest_time, "longest pause within one source");
  command.add_option("--slip-rate", options.slip_rate, "faces that move slower are aseismic");
  command.add_option("--stress-drop", options.stress_drop,
                     "faces that lose less shear traction are aseismic");
  command.add_option("--failure-rate", options.failure_rate, "rock that opens slower is aseismic");
  command.add_option("--thickness", options.thickness, "out of the plane of an event")
      ->check(CLI::IsMember({"layer", "equidimensional"}));
  command.add_option("--minimum-magnitude", options.minimum_magnitude,
                     "leaves smaller events out of points and QuakeML");
  command.add_option("--formats", options.formats, "of csv,hdf5,points,quakeml; all if not given")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--out", options.directory, "folder to write; RUN/seismicity_rebuilt if not given");
}

void add_conform_options(CLI::App& command, fissura::coupler::ConformOptions& options) {
  command.prefix_command();
  command.footer("CMD... is the solver's command; --connect ENDPOINT is appended to it.");
  command.add_option("--only", options.only, "checks of this name or subject, or that fit a pattern with *");
  command.add_option("--json", options.json, "writes the outcomes into this file")->type_name("FILE");
  command.add_flag("--list", options.list, "prints the checks, carries out none");
  command.add_flag("--first-failure", options.first_failure, "ends at the first check that fails");
  command.add_option("--patience", options.patience, "wall seconds for any answer")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 1e6));
}

void add_tape_option(CLI::App& command, std::vector<std::string>& roles) {
  command.add_option("--tape", roles, "records every message of network, structure, or network,structure")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"structure", "network"}));
}

void add_replay_options(CLI::App& command, fissura::coupler::ReplayRunOptions& options) {
  command.add_option("RUN", options.run_directory, "run directory with a tape of that role")->required();
  command.add_option("--role", options.role, "network or structure")
      ->required()
      ->check(CLI::IsMember({"structure", "network"}));
  command.add_option("--command", options.command, "another program (of the network also by name); --connect ENDPOINT is appended")
      ->type_name("CMD");
  command.add_option("--epoch", options.epoch, "which life of the run; the newest if not given");
  command.add_option("--until", options.until, "last coupling interval to replay")->type_name("INTERVAL");
  command.add_flag("--debug-attach", options.debug_attach,
                   "waits for a debugger; no deadline ends the replay");
}

void add_bisect_options(CLI::App& command, fissura::coupler::BisectOptions& options) {
  command.add_option("RUN_A", options.first, "run directory with a tape")->required();
  command.add_option("RUN_B", options.second, "likewise")->required();
  command.add_option("--role", options.role, "network or structure; every one that both taped if not given")
      ->check(CLI::IsMember({"structure", "network"}));
  command.add_option("--epoch", options.epoch, "which life of the runs; the first if not given");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program(
      "Fissura: hydraulic fractures in tight rock. Launches structure and network and couples them.");
  program.set_version_flag("--version", FISSURA_VERSION);
  program.require_subcommand(1);
  fissura::coupler::RunOptions options;
  options.command_line.assign(argv, argv + argc);
  bool short_form = false;

  CLI::App* run = program.add_subcommand("run", "runs a case and compares its result with what it must give");
  add_case_options(*run, options.source, short_form);
  run->add_option("--out", options.directory, "run directory");
  run->add_option("--network", options.network_command,
                  "the flow solver: implicit, explicit, uniform or python; or the command of another one, to "
                  "which --connect ENDPOINT is appended");
  run->add_option("--structure", options.structure_command,
                  "another structure; --connect ENDPOINT is appended");
  run->add_option("--threads", options.threads, "threads of the structure; every core if not given")
      ->check(CLI::Range(1, 1024));
  run->add_option("--until", options.until, "an earlier end, e.g. \"2 s\"; without a verdict");
  run->add_option("--fault", options.fault,
                  "injects a fault: ROLE@INTERVAL=kill, stop, spin, fail, exit, nan, ...");
  run->add_option("--fault-plan", options.fault_plan, "injects the faults of this file (docs/operation.md)")
      ->type_name("FILE");
  run->add_flag("--heal", options.heal, "goes on by itself after a process died or hung");
  run->add_flag("--debug-attach", options.debug_attach, "for a debugger: no deadline ends the run");
  run->add_option("--keys", options.keys, "directory with keys: participants must prove theirs")
      ->type_name("DIR");
  run->add_option("--await", options.awaited,
                  "structure or network: somebody else starts it, perhaps elsewhere")
      ->check(CLI::IsMember({"structure", "network"}))
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_tape_option(*run, options.tape);
  run->add_flag("--json", options.json, "prints the summary as JSON");

  fissura::coupler::ResumeOptions resume_options;
  CLI::App* resume = program.add_subcommand("resume", "goes on with a run that ended before its time");
  resume->add_option("RUN", resume_options.directory, "run directory")->required();
  resume->add_option("--threads", resume_options.threads, "threads of the structure; as before if not given")
      ->check(CLI::Range(1, 1024));
  resume->add_option("--network", resume_options.network_command,
                     "another flow solver goes on, named as in run; the same if not given");
  resume->add_option("--fault", resume_options.fault, "injects a fault, as in run");
  resume->add_option("--fault-plan", resume_options.fault_plan, "injects the faults of this file, as in run")
      ->type_name("FILE");
  resume->add_flag("--heal", resume_options.heal, "goes on by itself after a process died or hung");
  add_tape_option(*resume, resume_options.tape);
  resume->add_flag("--json", resume_options.json, "prints the summary as JSON");

  CLI::App* check = program.add_subcommand("check", "every fault of a case, or what follows from it");
  add_case_options(*check, options.source, short_form);
  std::optional<std::filesystem::path> picture;
  check->add_option("--svg", picture, "draws domain, fractures and in-situ stress into this file")
      ->type_name("FILE");

  std::filesystem::path run_directory;
  std::optional<std::filesystem::path> page;
  CLI::App* report = program.add_subcommand("report", "the results of a run as one HTML page with pictures");
  report->add_option("RUN", run_directory, "run directory; the run may still be going on")->required();
  report->add_option("--out", page, "file to write; report.html in the run directory if not given");

  fissura::coupler::SeismicityOptions seismicity_options;
  CLI::App* seismicity =
      program.add_subcommand("seismicity", "makes the catalogue of seismic events of a run again");
  add_seismicity_options(*seismicity, seismicity_options);

  bool as_json = false;
  CLI::App* status = program.add_subcommand("status", "what a run is doing, or how it ended");
  status->add_option("RUN", run_directory, "run directory")->required();
  status->add_flag("--json", as_json, "prints it as JSON");

  bool now = false;
  double patience = 60;
  CLI::App* stop = program.add_subcommand("stop", "ends a run at its next coupling time, with a checkpoint");
  stop->add_option("RUN", run_directory, "run directory")->required();
  stop->add_flag("--now", now, "at once, without a checkpoint");
  stop->add_option("--wait", patience, "seconds to wait for the end")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e6));

  CLI::App* verify = program.add_subcommand("verify", "compares every file of a run with what was written");
  verify->add_option("RUN", run_directory, "run directory; the run may be going on")->required();

  std::filesystem::path key_directory;
  CLI::App* keys = program.add_subcommand("keys", "keys of coupler and participants, for runs across hosts");
  keys->require_subcommand(1);
  CLI::App* new_keys = keys->add_subcommand("new", "makes the keys of one trio");
  new_keys->add_option("DIR", key_directory, "directory to write them into")->required();

  fissura::coupler::ConformOptions conform_options;
  CLI::App* conform = program.add_subcommand("conform", "whether a flow solver keeps the contract");
  add_conform_options(*conform, conform_options);

  fissura::coupler::ReplayRunOptions replay_options;
  CLI::App* replay =
      program.add_subcommand("replay", "runs a participant alone against the tape of a run");
  add_replay_options(*replay, replay_options);

  fissura::coupler::BisectOptions bisect_options;
  CLI::App* bisect = program.add_subcommand("bisect", "where the tapes of two runs part, and who said it");
  add_bisect_options(*bisect, bisect_options);

  try {
    program.parse(argc, argv);
    conform_options.command = conform->remaining();
    if (conform->parsed()) return fissura::coupler::conform_command(conform_options);
    if (short_form) options.source.variants.emplace_back("short");
    if (new_keys->parsed()) return fissura::coupler::new_keys_command(key_directory);
    if (run->parsed()) return fissura::coupler::run_command(options);
    if (resume->parsed()) return fissura::coupler::resume_command(resume_options);
    if (report->parsed()) return fissura::coupler::report_command(run_directory, page);
    if (status->parsed())
      return fissura::coupler::status_command(run_directory, as_json ? StatusForm::json : StatusForm::text);
    if (stop->parsed())
      return fissura::coupler::stop_command(run_directory,
                                            now ? StopTime::at_once : StopTime::next_coupling_time, patience);
    if (verify->parsed()) return fissura::coupler::verify_command(run_directory);
    if (replay->parsed()) return fissura::coupler::replay_command(replay_options);
    if (bisect->parsed()) return fissura::coupler::bisect_command(bisect_options);
    if (seismicity->parsed()) return fissura::coupler::seismicity_command(seismicity_options);
    return fissura::coupler::check_command(options.source, picture);
  } catch (const CLI::ParseError& fault) {
    return program.exit(fault) == 0 ? 0 : static_cast<int>(ExitCode::command_line);
  } catch (const fissura::Error& fault) {
    std::fprintf(stderr, "coupler: %s: %s\n", fissura::name(fault.code()), fault.what());
    return static_cast<int>(fault.code());
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "coupler: %s: %s\n", fissura::name(ExitCode::internal), fault.what());
    return static_cast<int>(ExitCode::internal);
  }
}
