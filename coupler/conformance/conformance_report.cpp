// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/conformance/conformance_report.hpp"

#include <fmt/format.h>

#include <string_view>

namespace fissura::coupler::conformance {

namespace {

constexpr std::size_t longest_shown = 100;

/// UTF-8 is cut between characters only.
std::string shortened(const std::string& text) {
  if (text.size() <= longest_shown) return text;
  std::size_t end = longest_shown - 3;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end) + "...";
}

const char* key_of(Verdict verdict) {
  return verdict == Verdict::passed ? "passed" : verdict == Verdict::failed ? "failed" : "not_claimed";
}

std::string joined(const std::set<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "none" : text;
}

}  // namespace

std::string lines_of(const Outcome& outcome) {
  if (outcome.verdict != Verdict::failed)
    return fmt::format("{:<12}{:<34}{:6.2f} s  {}\n", name(outcome.verdict), outcome.name, outcome.seconds,
                       shortened(outcome.obtained));
  std::string text =
      fmt::format("{:<12}{:<34}{:6.2f} s\n", name(outcome.verdict), outcome.name, outcome.seconds);
  const auto line = [&text](const char* key, const std::string& value) {
    text += fmt::format("            {:<10}{}\n", key, value);
  };
  if (outcome.promise != outcome.expected) line("promise", outcome.promise);
  line("expected", outcome.expected);
  line("obtained", outcome.obtained);
  line("contract", outcome.contract);
  return text;
}

std::string heading(const Greeting& greeting) {
  return fmt::format("{} {}; physics: {}; capabilities: {}\n", greeting.solver, greeting.version,
                     greeting.physics ? joined(*greeting.physics) : "not told, all is assumed",
                     joined(greeting.capabilities));
}

std::string closing(const ConformanceResult& result) {
  double seconds = 0;
  for (const Outcome& outcome : result.outcomes) seconds += outcome.seconds;
  return fmt::format("{} checks: {} passed, {} failed, {} not claimed, in {:.1f} s\n", result.outcomes.size(),
                     result.count(Verdict::passed), result.count(Verdict::failed),
                     result.count(Verdict::not_claimed), seconds);
}

std::string listing(const std::vector<Check>& checks) {
  std::string text;
  for (const Check& check : checks)
    text += fmt::format("{:<34}{:<24}{}\n", check.name, check.contract, check.expected);
  return text;
}

nlohmann::json report_json(const ConformanceResult& result, const std::string& command) {
  nlohmann::json report;
  report["command"] = command;
  report["solver"] = result.greeting.solver;
  report["version"] = result.greeting.version;
  report["capabilities"] = result.greeting.capabilities;
  report["physics"] = nullptr;
  if (result.greeting.physics) report["physics"] = *result.greeting.physics;
  report["checks"] = nlohmann::json::array();
  for (const Outcome& outcome : result.outcomes)
    report["checks"].push_back({{"name", outcome.name},
                                {"contract", outcome.contract},
                                {"verdict", key_of(outcome.verdict)},
                                {"promise", outcome.promise},
                                {"expected", outcome.expected},
                                {"obtained", outcome.obtained},
                                {"seconds", outcome.seconds}});
  for (const Verdict verdict : {Verdict::passed, Verdict::failed, Verdict::not_claimed})
    report[key_of(verdict)] = result.count(verdict);
  return report;
}

}  // namespace fissura::coupler::conformance
