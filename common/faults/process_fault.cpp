// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/faults/process_fault.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

namespace fissura {

namespace {

const std::vector<std::string> roles{"structure", "network", "coupler"};

constexpr std::array participant_phases{FaultPhase::hello,   FaultPhase::join,    FaultPhase::insert,
                                        FaultPhase::advance, FaultPhase::answer,  FaultPhase::report,
                                        FaultPhase::save,    FaultPhase::restore, FaultPhase::finish};

constexpr std::array coupler_phases{
    FaultPhase::start,  FaultPhase::network, FaultPhase::structure,          FaultPhase::insertion,
    FaultPhase::report, FaultPhase::segment, FaultPhase::checkpoint_prepare, FaultPhase::checkpoint_commit,
    FaultPhase::finish, FaultPhase::resume};

constexpr double longest_pause = 86400;

bool spoils_a_value(FaultAction action) {
  return action == FaultAction::nan || action == FaultAction::negative;
}

bool concerns_files(FaultAction action) {
  return action == FaultAction::disk_full || action == FaultAction::write_error ||
         action == FaultAction::sync_error || action == FaultAction::rename_error;
}

bool changes_arithmetic(FaultAction action) {
  return action == FaultAction::round_up || action == FaultAction::flush_denormals;
}

std::vector<std::string> actions_at(std::string_view role, std::string_view phase) {
  std::vector<std::string> actions;
  for (const Named<FaultAction>& each : fault_actions)
    if (!(spoils_a_value(each.value) && phase != "answer") &&
        !(concerns_files(each.value) && role != "coupler") &&
        !(changes_arithmetic(each.value) && role == "coupler"))
      actions.emplace_back(each.name);
  return actions;
}

template <class E, std::size_t N>
E value_of(std::string_view word, const std::array<Named<E>, N>& names, E fallback) {
  for (const Named<E>& entry : names)
    if (entry.name == word) return entry.value;
  return fallback;
}

void read_action(input::TableReader& table, ProcessFault& fault) {
  const std::string phase = name_of(fault.phase, fault_phases);
  fault.action = value_of(table.word("do", actions_at(fault.role, phase)), fault_actions, fault.action);
  if (fault.action == FaultAction::stop_for || fault.action == FaultAction::sleep)
    fault.seconds = table.number("seconds", {0, longest_pause, false, true});
  if (fault.action == FaultAction::exit) fault.code = table.count("code", input::from_to(0, 255), fault.code);
  if (spoils_a_value(fault.action)) {
    fault.field = table.text("field", fault.field);
    fault.index = table.natural_number("index", fault.index);
  }
}

}  // namespace

std::vector<std::string> phases_of(std::string_view role) {
  std::vector<std::string> phases;
  const auto add = [&phases](FaultPhase phase) { phases.push_back(name_of(phase, fault_phases)); };
  if (role == "coupler")
    std::for_each(coupler_phases.begin(), coupler_phases.end(), add);
  else
    std::for_each(participant_phases.begin(), participant_phases.end(), add);
  return phases;
}

std::vector<ProcessFault> read_process_faults(input::TableReader& document) {
  std::vector<ProcessFault> faults;
  for (input::TableReader& table : document.optional_tables("fault")) {
    ProcessFault& fault = faults.emplace_back();
    fault.role = table.word("role", roles);
    fault.phase = value_of(table.word("phase", phases_of(fault.role)), fault_phases, fault.phase);
    fault.interval = table.natural_number_or_every("interval", std::nullopt);
    fault.epoch = table.natural_number_or_every("epoch", fault.epoch);
    fault.occurrence = static_cast<std::uint64_t>(table.count("occurrence", input::at_least(1), 1));
    read_action(table, fault);
    table.refuse_unknown_keys();
  }
  return faults;
}

ProcessFault parse_process_fault(const std::string& text) {
  const std::string expected =
      "expected ROLE@INTERVAL=DO or ROLE@INTERVAL:PHASE=DO with ROLE structure, network or coupler, and DO "
      "one of ";
  const auto refuse = [&](const std::vector<std::string>& actions) {
    throw InputError(fmt::format("fault \"{}\": {}{}", text, expected, listed(actions)));
  };
  const std::vector<std::string> short_actions{"kill",  "stop",     "spin",    "fail", "throw",   "exit",
                                               "abort", "segfault", "exhaust", "nan",  "negative"};
  const std::size_t at = text.find('@'), equals = text.find('=');
  if (at == std::string::npos || equals == std::string::npos || equals < at) refuse(short_actions);
  ProcessFault fault;
  fault.role = text.substr(0, at);
  std::string where = text.substr(at + 1, equals - at - 1);
  const std::string action = text.substr(equals + 1);
  if (std::find(roles.begin(), roles.end(), fault.role) == roles.end() ||
      std::find(short_actions.begin(), short_actions.end(), action) == short_actions.end())
    refuse(short_actions);
  fault.action = value_of(action, fault_actions, fault.action);

  std::string phase = spoils_a_value(fault.action) ? "answer"
                      : fault.role == "coupler"    ? "network"
                                                   : "advance";
  if (const std::size_t colon = where.find(':'); colon != std::string::npos) {
    phase = where.substr(colon + 1);
    where.resize(colon);
  }
  const std::vector<std::string> phases = phases_of(fault.role), possible = actions_at(fault.role, phase);
  if (std::find(phases.begin(), phases.end(), phase) == phases.end() ||
      std::find(possible.begin(), possible.end(), action) == possible.end())
    throw InputError(fmt::format("fault \"{}\": {} has the phases {}; nan and negative are for the answer",
                                 text, fault.role, listed(phases)));
  fault.phase = value_of(phase, fault_phases, fault.phase);

  std::uint64_t interval = 0;
  const auto result = std::from_chars(where.data(), where.data() + where.size(), interval);
  if (result.ec != std::errc{} || result.ptr != where.data() + where.size()) refuse(short_actions);
  fault.interval = interval;
  return fault;
}

}  // namespace fissura
