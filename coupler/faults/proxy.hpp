// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "coupler/faults/fault_plan.hpp"

namespace fissura::coupler {

struct ProxyOptions {
  std::filesystem::path plan;
  std::string role;      ///< "structure" or "network"
  std::string endpoint;  ///< of the coupler
  std::string command;   ///< shell command of the participant; `--connect ENDPOINT` is appended
  std::filesystem::path transcript;
};

/// The shell command that runs `command` behind a proxy: it takes the place of the participant, and
/// `--connect ENDPOINT` may be appended to it.
std::string behind_proxy(const std::string& proxy_program, const std::filesystem::path& plan,
                         const std::string& role, const std::filesystem::path& transcript,
                         const std::string& command);

/// Stands between the coupler and one participant until that has ended. To the coupler it is the participant:
/// it ends with the same exit code, or by the same signal, passes signals on to it, and is stopped while it
/// is.
/// @returns the exit code
int run_proxy(const ProxyOptions& options);

}  // namespace fissura::coupler
