// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace fissura::coupler {

/// `coupler replay`, as typed.
struct ReplayRunOptions {
  std::filesystem::path run_directory;
  std::string role;                    ///< "structure" or "network"
  std::optional<std::string> command;  ///< default: that of the run
  std::optional<std::uint32_t> epoch;  ///< default: the newest that is taped
  std::optional<std::uint64_t> until;  ///< last coupling interval
  bool debug_attach = false;           ///< waits for a debugger, and no deadline ends the replay
};

/// Runs a participant of a run alone against its tape and prints what came of it.
/// @returns the exit code of the program: 0 identical, 1 an answer differs
int replay_command(const ReplayRunOptions& options);

/// `coupler bisect`, as typed.
struct BisectOptions {
  std::filesystem::path first, second;  ///< run directories
  std::optional<std::string> role;      ///< default: every role that both have taped
  std::optional<std::uint32_t> epoch;   ///< default: the first that both have taped
};

/// Compares the tapes of two runs and prints where they part, and who said it.
/// @returns the exit code of the program: 0 they say the same, 1 they part
int bisect_command(const BisectOptions& options);

}  // namespace fissura::coupler
