// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <cstdio>

#include "common/errors.hpp"
#include "coupler/faults/proxy.hpp"

int main(int argc, char** argv) {
  using fissura::ExitCode;
  CLI::App program(
      "Fissura fault proxy: stands between the coupler and one participant and spoils messages as a plan "
      "says");
  fissura::coupler::ProxyOptions options;
  options.transcript = "/dev/null";
  program.add_option("--plan", options.plan, "fault plan (docs/operation.md)")->required()->type_name("FILE");
  program.add_option("--role", options.role, "whose messages")
      ->required()
      ->check(CLI::IsMember({"structure", "network"}));
  program.add_option("--connect", options.endpoint, "endpoint of the coupler")->required();
  program.add_option("--command", options.command, "the participant; --connect ENDPOINT is appended")
      ->required();
  program.add_option("--transcript", options.transcript, "file to append what passed to")->type_name("FILE");
  program.set_version_flag("--version", FISSURA_VERSION);
  try {
    program.parse(argc, argv);
    return fissura::coupler::run_proxy(options);
  } catch (const CLI::ParseError& fault) {
    return program.exit(fault) == 0 ? 0 : static_cast<int>(ExitCode::command_line);
  } catch (const fissura::Error& fault) {
    std::fprintf(stderr, "fault_proxy: %s: %s\n", fissura::name(fault.code()), fault.what());
    return static_cast<int>(fault.code());
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "fault_proxy: %s: %s\n", fissura::name(ExitCode::internal), fault.what());
    return static_cast<int>(ExitCode::internal);
  }
}
