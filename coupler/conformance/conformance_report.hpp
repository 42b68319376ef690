// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "coupler/conformance/conformance_run.hpp"

/// The outcomes for people and for scripts.
namespace fissura::coupler::conformance {

/// One line; a failure has more: the promise, what of it was expected, what was obtained, and where the
/// contract says so.
std::string lines_of(const Outcome& outcome);

/// Who is tested.
std::string heading(const Greeting& greeting);
/// How many passed.
std::string closing(const ConformanceResult& result);
/// Name, contract and expectation of each check, for `--list`.
std::string listing(const std::vector<Check>& checks);

/// {"solver", "version", "physics" (null: not told), "capabilities", "command", "checks": [{"name",
/// "contract", "verdict", "promise", "expected", "obtained", "seconds"}], "passed", "failed", "not_claimed"}
nlohmann::json report_json(const ConformanceResult& result, const std::string& command);

}  // namespace fissura::coupler::conformance
