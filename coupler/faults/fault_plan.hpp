// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/faults/process_fault.hpp"
#include "coupler/faults/message_fault.hpp"

namespace fissura::coupler {

/// Everything that is to go wrong in a run.
struct FaultPlan {
  std::vector<ProcessFault> processes;
  std::vector<MessageFault> messages;
  bool transcript = false;  ///< every message is written down, also where none is spoilt

  /// Whether the messages of `role` go through a proxy.
  [[nodiscard]] bool relays(const std::string& role) const;
};

/// Reads a fault plan (TOML, docs/operation.md). Throws InputError with every fault of the file: line, key,
/// what was found, what is allowed.
FaultPlan read_fault_plan(const std::filesystem::path& file);

}  // namespace fissura::coupler
