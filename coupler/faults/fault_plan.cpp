// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/faults/fault_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "common/case/toml_document.hpp"

namespace fissura::coupler {

namespace {

void throw_if_any(FaultList faults) {
  if (faults.empty()) return;
  std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
    return std::tie(a.where.line, a.where.column) < std::tie(b.where.line, b.where.column);
  });
  std::string text = faults.size() == 1
                         ? "something is wrong with the fault plan:"
                         : fmt::format("{} things are wrong with the fault plan:", faults.size());
  for (const Fault& fault : faults) text += "\n  " + describe(fault);
  throw InputError(text);
}

}  // namespace

bool FaultPlan::relays(const std::string& role) const {
  return transcript || std::any_of(messages.begin(), messages.end(),
                                   [&](const MessageFault& each) { return each.role == role; });
}

FaultPlan read_fault_plan(const std::filesystem::path& file) {
  FaultList faults;
  const input::SourceValue document = input::read_toml(file, faults);
  throw_if_any(faults);
  input::TableReader reader(document, "", faults);
  FaultPlan plan;
  plan.processes = read_process_faults(reader);
  plan.messages = read_message_faults(reader);
  plan.transcript = reader.flag("transcript", plan.transcript);
  reader.refuse_unknown_keys();
  throw_if_any(faults);
  return plan;
}

}  // namespace fissura::coupler
