// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fissura::coupler {

struct ConformOptions {
  std::vector<std::string> command;  ///< words; of the built-in flow solver without any
  std::string only = "*";            ///< pattern of names
  std::optional<std::filesystem::path> json;
  bool list = false;
  bool first_failure = false;  ///< ends there
  double patience = 10;  ///< wall seconds for any answer
};

/// Drives a flow solver alone through every check of the contract and prints what was obtained.
/// @returns the exit code: 0 if all checks that apply are passed, 1 if not
int conform_command(const ConformOptions& options);

}  // namespace fissura::coupler
