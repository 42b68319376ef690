// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/replay_command.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "common/errors.hpp"
#include "common/exchange/debugger.hpp"
#include "coupler/cli/flow_solver_command.hpp"
#include "coupler/cli/prepared_run.hpp"
#include "coupler/launch/process_activity.hpp"
#include "coupler/tape/bisect.hpp"
#include "coupler/tape/replay.hpp"

namespace fissura::coupler {

namespace {

Role role_named(const std::string& text) {
  return text == name(Role::structure) ? Role::structure : Role::network;
}

std::string command_of(const ReplayRunOptions& options, Role role) {
  if (options.command)
    return role == Role::network ? flow_solver_command(*options.command) : *options.command;
  const PreparedRun run = read_resume_file(options.run_directory);
  return role == Role::structure ? run.structure_command : run.network_command;
}

std::uint32_t newest_epoch(const std::filesystem::path& run_directory, Role role) {
  const std::vector<std::uint32_t> epochs = taped_epochs(run_directory, role);
  if (epochs.empty())
    throw Error(ExitCode::precondition,
                fmt::format("{} has no tape of its {}: record one with `coupler run --tape {}`",
                            run_directory.string(), name(role), name(role)));
  return epochs.back();
}

/// Returns when a debugger holds the process, or at a line or the end of standard input.
void wait_for_debugger(const std::string& role, long pid) {
  if (tracer_of(static_cast<pid_t>(pid))) return;
  std::fprintf(stderr, "%s is process %ld: gdb -p %ld, or Enter to go on without\n", role.c_str(), pid, pid);
  while (!tracer_of(static_cast<pid_t>(pid))) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (::poll(&input, 1, 100) <= 0) continue;
    char letters[256];
    (void)!::read(STDIN_FILENO, letters, sizeof(letters));
    return;
  }
}

std::string ratio(double live, double now) {
  return now > 0 ? fmt::format("{:.2f} times as fast", live / now) : "at once";
}

void print(const ReplayResult& result, const std::filesystem::path& tape) {
  if (result.solver != result.taped_solver)
    std::printf("%s answers, the tape is of %s\n", result.solver.c_str(), result.taped_solver.c_str());
  std::printf("%s", result.finding.c_str());
  std::printf("%llu answers are identical to those of %s, up to interval %llu\n",
              static_cast<unsigned long long>(result.identical), tape.c_str(),
              static_cast<unsigned long long>(result.interval));
  std::printf("wall time %.3f s, live %.3f s: %s; of it for answers %.3f s, live %.3f s\n", result.seconds,
              result.live_seconds, ratio(result.live_seconds, result.seconds).c_str(), result.answering,
              result.live_answering);
}

void print_other_epochs(const ReplayRunOptions& options, Role role) {
  if (options.epoch) return;
  std::vector<std::uint32_t> others = taped_epochs(options.run_directory, role);
  others.pop_back();
  if (!others.empty())
    std::printf("earlier lives of the run are taped too: --epoch %s\n",
                fmt::format("{}", fmt::join(others, ", ")).c_str());
}

/// The first epoch of which both runs have a tape of `role`.
std::optional<std::uint32_t> common_epoch(const BisectOptions& options, Role role) {
  const auto first = taped_epochs(options.first, role), second = taped_epochs(options.second, role);
  for (const std::uint32_t epoch : first)
    if (std::find(second.begin(), second.end(), epoch) != second.end()) return epoch;
  return std::nullopt;
}

void print(const TapeComparison& comparison) {
  std::printf("%s: %llu messages are identical%s", name(comparison.role),
              static_cast<unsigned long long>(comparison.identical),
              comparison.parting ? fmt::format(", up to interval {}; then\n", comparison.interval).c_str()
                                 : ", from the first to the last\n");
  if (comparison.parting) std::printf("%s", comparison.parting->sentence.c_str());
}

}  // namespace

int replay_command(const ReplayRunOptions& options) {
  const Role role = role_named(options.role);
  ReplayOptions replayed;
  replayed.tape = tape_file(options.run_directory, role,
                            options.epoch ? *options.epoch : newest_epoch(options.run_directory, role));
  replayed.command = command_of(options, role);
  replayed.until = options.until;
  if (options.debug_attach) {
    replayed.patience = Patience::endless;
    announce_debugger();
    replayed.on_hello = [&](long pid) { wait_for_debugger(options.role, pid); };
  }
  replayed.on_end = [&](const ReplayResult& result) {
    print(result, replayed.tape);
    print_other_epochs(options, role);
    std::fflush(stdout);
  };
  return static_cast<int>(replay(replayed).code);
}

int bisect_command(const BisectOptions& options) {
  std::vector<TapeComparison> comparisons;
  for (const Role role : {Role::structure, Role::network}) {
    if (options.role && role_named(*options.role) != role) continue;
    const std::optional<std::uint32_t> epoch = options.epoch ? options.epoch : common_epoch(options, role);
    if (!epoch) continue;
    const auto first = tape_file(options.first, role, *epoch),
               second = tape_file(options.second, role, *epoch);
    if (!options.role && !(std::filesystem::exists(first) && std::filesystem::exists(second))) continue;
    comparisons.push_back(compare_tapes(first, second));
    print(comparisons.back());
  }
  if (comparisons.empty())
    throw Error(
        ExitCode::precondition,
        fmt::format("{} and {} have no tapes of the same role and epoch: record them with `coupler run "
                    "--tape ROLE`",
                    options.first.string(), options.second.string()));
  std::printf("%s", verdict_of(comparisons).c_str());
  const bool same = std::none_of(comparisons.begin(), comparisons.end(),
                                 [](const TapeComparison& each) { return each.parting.has_value(); });
  return static_cast<int>(same ? ExitCode::done : ExitCode::verdict_failed);
}

}  // namespace fissura::coupler
