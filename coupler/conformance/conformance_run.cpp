// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/conformance/conformance_run.hpp"

#include <fmt/format.h>
#include <fnmatch.h>
#include <sys/prctl.h>

#include <algorithm>
#include <chrono>

#include "common/errors.hpp"
#include "coupler/launch/process_tree.hpp"

namespace fissura::coupler::conformance {

namespace {

/// What of `needed` is missing, as a list of words.
std::string missing(const std::set<std::string>& needed, const std::set<std::string>& claimed) {
  std::string text;
  for (const std::string& each : needed)
    if (!claimed.contains(each)) text += (text.empty() ? "" : ", ") + each;
  return text;
}

std::string not_claimed(const Check& check, const Greeting& greeting) {
  const std::string physics = greeting.physics ? missing(check.physics, *greeting.physics) : "";
  const std::string capabilities = missing(check.capabilities, greeting.capabilities);
  return physics + (physics.empty() || capabilities.empty() ? "" : ", ") + capabilities;
}

void carry_out(const Check& check, const Candidate& candidate, Outcome& outcome) {
  try {
    outcome.obtained = check.carry_out(candidate);
    outcome.verdict = Verdict::passed;
  } catch (const Deviation& deviation) {
    outcome.expected = deviation.expected();
    outcome.obtained = deviation.obtained();
  } catch (const Error& fault) {
    outcome.obtained = fault.what();
  }
}

Outcome outcome_of(const Check& check, const Candidate& candidate, const Greeting& greeting) {
  Outcome outcome{.name = check.name,
                  .contract = check.contract,
                  .promise = check.expected,
                  .expected = check.expected,
                  .obtained = {}};
  if (const std::string lacking = not_claimed(check, greeting); !lacking.empty()) {
    outcome.verdict = Verdict::not_claimed;
    outcome.obtained = "the solver does not claim " + lacking;
    return outcome;
  }
  const auto begin = std::chrono::steady_clock::now();
  carry_out(check, candidate, outcome);
  end_descendants({});
  outcome.seconds = Seconds(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

}  // namespace

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return "passed";
    case Verdict::failed:
      return "FAILED";
    case Verdict::not_claimed:
      return "not claimed";
  }
  return "";
}

std::size_t ConformanceResult::count(Verdict verdict) const {
  return static_cast<std::size_t>(
      std::count_if(outcomes.begin(), outcomes.end(),
                    [verdict](const Outcome& outcome) { return outcome.verdict == verdict; }));
}

std::vector<Check> selected(std::vector<Check> checks, const std::string& pattern) {
  std::erase_if(checks, [&pattern](const Check& check) {
    return ::fnmatch(pattern.c_str(), check.name.c_str(), 0) != 0 && !check.name.starts_with(pattern + ".");
  });
  return checks;
}

ConformanceResult run_conformance(const Candidate& candidate, const std::vector<Check>& checks,
                                  const std::function<Next(const Outcome&)>& each) {
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);  // so that orphans of a candidate become children of this process
  ConformanceResult result;
  result.greeting = Driver(candidate).greeting();
  end_descendants({});
  for (const Check& check : checks) {
    result.outcomes.push_back(outcome_of(check, candidate, result.greeting));
    if (each(result.outcomes.back()) == Next::stop) break;
  }
  return result;
}

}  // namespace fissura::coupler::conformance
