// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/last_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <string_view>

#include "common/errors.hpp"
#include "coupler/checkpoint/checkpoint_store.hpp"

namespace fissura::coupler {

namespace {

std::string for_a_shell(const std::string& word) {
  constexpr std::string_view harmless =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
  if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char character : word)
    quoted += character == '\'' ? std::string("'\\''") : std::string(1, character);
  return quoted + "'";
}

std::string on_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

}  // namespace

std::string name_of_code(int exit_code) {
  return exit_code == 128 + SIGHUP ? "HANGUP" : name(static_cast<ExitCode>(exit_code));
}

std::optional<std::uint64_t> newest_checkpoint(const std::filesystem::path& run_directory) {
  try {
    const std::vector<std::string> names = CheckpointStore(run_directory, 2).names();
    return names.empty() ? std::nullopt : std::optional<std::uint64_t>(std::stoull(names.back()));
  } catch (const std::exception&) {
    return std::nullopt;  // what cannot be listed cannot be resumed from either
  }
}

std::string place(const std::optional<std::uint64_t>& checkpoint) {
  return checkpoint ? fmt::format("interval {}", *checkpoint) : "the beginning";
}

bool can_resume_after(int exit_code) {
  constexpr std::array never{ExitCode::done,         ExitCode::verdict_failed, ExitCode::command_line,
                             ExitCode::case_invalid, ExitCode::precondition,   ExitCode::role_taken,
                             ExitCode::mismatch,     ExitCode::security};
  return std::find(never.begin(), never.end(), static_cast<ExitCode>(exit_code)) == never.end();
}

std::string resume_command(const std::filesystem::path& run_directory) {
  return "coupler resume " + for_a_shell(run_directory.string());
}

std::string last_line(const RunFailure& failure) {
  return fmt::format("coupler: {} {} interval={} phase={}: {}", name_of_code(failure.exit_code),
                     failure.who.text(), failure.interval, failure.phase.text(),
                     on_one_line(failure.sentence.text()));
}

std::string last_line(const RunFailure& failure, const std::filesystem::path& run_directory,
                      const std::optional<std::uint64_t>& checkpoint) {
  if (!can_resume_after(failure.exit_code)) return last_line(failure);
  return fmt::format("{}. Resume: {} (from {})", last_line(failure), resume_command(run_directory),
                     place(checkpoint));
}

}  // namespace fissura::coupler
