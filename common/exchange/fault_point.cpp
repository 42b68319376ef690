// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/fault_point.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <csignal>
#include <cstdlib>
#include <map>

#include "common/errors.hpp"

namespace fissura {

FaultPlan parse_fault_plan(const std::string& text) {
  static const std::map<std::string, FaultKind> kinds{{"kill", FaultKind::kill}, {"stop", FaultKind::stop},
                                                      {"spin", FaultKind::spin}, {"fail", FaultKind::fail},
                                                      {"exit", FaultKind::exit}, {"nan", FaultKind::nan}};
  const std::size_t at = text.find('@'), equals = text.find('=');
  const std::string expected = "expected ROLE@INTERVAL=KIND with KIND kill, stop, spin, fail, exit or nan";
  if (at == std::string::npos || equals == std::string::npos || equals < at)
    throw InputError(fmt::format("fault plan \"{}\": {}", text, expected));
  FaultPlan plan;
  plan.role = text.substr(0, at);
  const std::string number = text.substr(at + 1, equals - at - 1);
  const auto result = std::from_chars(number.data(), number.data() + number.size(), plan.interval);
  const auto kind = kinds.find(text.substr(equals + 1));
  const bool known_role = plan.role == "structure" || plan.role == "network" || plan.role == "coupler";
  if (!known_role || result.ec != std::errc{} || result.ptr != number.data() + number.size() || kind == kinds.end())
    throw InputError(fmt::format("fault plan \"{}\": {}", text, expected));
  plan.kind = kind->second;
  return plan;
}

std::optional<FaultPlan> fault_plan_of_environment(const std::string& role) {
  const char* text = std::getenv("FISSURA_FAULT");
  if (text == nullptr) return std::nullopt;
  FaultPlan plan = parse_fault_plan(text);
  if (plan.role != role) return std::nullopt;
  return plan;
}

bool fault_point(const std::optional<FaultPlan>& plan, std::uint64_t interval) {
  if (!plan || plan->interval != interval) return false;
  switch (plan->kind) {
    case FaultKind::kill: ::raise(SIGKILL); break;
    case FaultKind::stop: ::raise(SIGSTOP); break;
    case FaultKind::spin:
      for (volatile unsigned long turns = 0;;) turns = turns + 1;
    case FaultKind::fail:
      throw SolverError(fmt::format("injected failure in interval {}", interval));
    case FaultKind::exit: ::_exit(0);
    case FaultKind::nan: return true;
  }
  return false;
}

}  // namespace fissura
