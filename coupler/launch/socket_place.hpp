// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace fissura::coupler {

/// Where the local socket of a run lies: coupler.ipc in its directory or, as an address of the system holds
/// about a hundred characters, in a directory of mode 0700 among the temporary ones whose name follows from
/// that of the run directory. For the process that holds the run directory: what a run that was killed left
/// there is removed at the beginning, everything at the end, whoever made it.
class SocketPlace {
 public:
  /// Throws Error(precondition), or Error(security) if another user has prepared the temporary directory.
  explicit SocketPlace(const std::filesystem::path& run_directory);
  ~SocketPlace();
  SocketPlace(const SocketPlace&) = delete;
  SocketPlace& operator=(const SocketPlace&) = delete;

  /// ipc://PATH
  [[nodiscard]] std::string endpoint() const { return "ipc://" + path_.string(); }

 private:
  std::filesystem::path path_, temporary_;
};

}  // namespace fissura::coupler
