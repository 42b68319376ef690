// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/conform_command.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>

#include "common/errors.hpp"
#include "coupler/cli/flow_solver_command.hpp"
#include "coupler/conformance/conformance_report.hpp"

namespace fissura::coupler {

namespace {

using namespace conformance;

/// One word is what `--network` takes, the name of a shipped flow solver or a shell command; several are the
/// words of one.
std::string shell_command(const std::vector<std::string>& words) {
  if (words.empty()) return flow_solver_command("implicit");
  if (words.size() == 1) return flow_solver_command(words.front());
  std::string line;
  for (const std::string& word : words) {
    line += line.empty() ? "'" : " '";
    for (const char letter : word) line += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    line += "'";
  }
  return line;
}

void print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
}

void write(const std::filesystem::path& file, const nlohmann::json& report) {
  std::ofstream stream(file);
  stream << report.dump(2) << '\n';
  stream.close();
  if (!stream) throw StorageError(fmt::format("{} cannot be written", file.string()));
}

}  // namespace

int conform_command(const ConformOptions& options) {
  const std::vector<Check> checks = selected(all_checks(), options.only);
  if (checks.empty())
    throw Error(ExitCode::command_line, fmt::format("no check has a name that fits \"{}\"", options.only));
  if (options.list) {
    print(listing(checks));
    return static_cast<int>(ExitCode::done);
  }
  const std::string command = shell_command(options.command);
  const Candidate candidate{.command = command, .patience = Seconds(options.patience)};
  ConformanceResult result;
  try {
    result = run_conformance(candidate, checks, [&options](const Outcome& outcome) {
      print(lines_of(outcome));
      return options.first_failure && outcome.verdict == Verdict::failed ? Next::stop : Next::go_on;
    });
  } catch (const Deviation& deviation) {
    throw Error(ExitCode::verdict_failed, fmt::format("\"{}\": {}", command, deviation.what()));
  }
  print(heading(result.greeting) + closing(result));
  if (options.json) write(*options.json, report_json(result, command));
  return static_cast<int>(result.count(Verdict::failed) == 0 ? ExitCode::done : ExitCode::verdict_failed);
}

}  // namespace fissura::coupler
