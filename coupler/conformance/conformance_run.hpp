// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "coupler/conformance/check.hpp"
#include "coupler/conformance/driver.hpp"

namespace fissura::coupler::conformance {

enum class Verdict {
  passed,
  failed,
  not_claimed  ///< the solver does not claim what the check needs
};

/// "passed", "FAILED", "not claimed"
const char* name(Verdict verdict);

struct Outcome {
  std::string name, contract;
  std::string promise;             ///< `expected` of the check
  std::string expected, obtained;  ///< the same, and what was obtained; of a failure, what failed of it
  Verdict verdict = Verdict::failed;
  double seconds = 0;  ///< wall
};

struct ConformanceResult {
  Greeting greeting;
  std::vector<Outcome> outcomes;
  [[nodiscard]] std::size_t count(Verdict verdict) const;
};

/// Checks whose name fits `pattern`: one with * and ? as in the shell, or a name or subject ("insertion").
std::vector<Check> selected(std::vector<Check> checks, const std::string& pattern);

/// What comes after an outcome.
enum class Next { go_on, stop };

/// Hears HELLO of the candidate once, then carries out each check that applies, one after the other; whatever
/// processes a check leaves behind are ended. Tells `each` of every outcome at once, until it says stop.
/// Throws Deviation if the candidate does not greet.
ConformanceResult run_conformance(const Candidate& candidate, const std::vector<Check>& checks,
                                  const std::function<Next(const Outcome&)>& each);

}  // namespace fissura::coupler::conformance
