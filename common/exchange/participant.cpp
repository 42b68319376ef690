// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/participant.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>

#include "common/exchange/held_signals.hpp"
#include "common/exchange/session.hpp"
#include "common/exchange/stack_dump.hpp"
#include "common/log.hpp"

namespace fissura {

int run_participant(Role role, const ParticipantOptions& options, Solver& solver) {
  return Session(role, options, solver).run();
}

int participant_main(Role role, int argc, char** argv, const char* solver_name, const char* solver_version,
                     Solver& solver) {
  CLI::App program(fmt::format("Fissura {} participant: started by the coupler", name(role)));
  ParticipantOptions options;
  options.solver_name = solver_name;
  options.solver_version = solver_version;
  std::string level = "info";
  program.add_option("--connect", options.endpoint, "endpoint of the coupler")->required();
  std::optional<std::filesystem::path> keys;
  program.add_option("--keys", keys, fmt::format("directory with {}.secret and coupler.public", name(role)));
  program.add_option("--log", level, "debug, info, warn or error");
  program.set_version_flag("--version", options.solver_version);
  try {
    program.parse(argc, argv);
    log::start(name(role), level);
    // Ctrl-C reaches the whole terminal group; only the coupler decides what it means.
    std::signal(SIGINT, SIG_IGN);
    hold_signals({SIGTERM, SIGHUP});
    dump_stack_on_request();
    if (keys) options.keys = read_participant_keys(*keys, name(role));
    return run_participant(role, options, solver);
  } catch (const CLI::ParseError& fault) {
    return program.exit(fault) == 0 ? 0 : static_cast<int>(ExitCode::command_line);
  } catch (const Error& fault) {
    std::fprintf(stderr, "%s: %s: %s\n", name(role), fissura::name(fault.code()), fault.what());
    return static_cast<int>(fault.code());
  }
}

}  // namespace fissura
