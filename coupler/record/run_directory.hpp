// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace fissura::coupler {

/// The directory of one run, held by one process. Mode 0700, because the endpoints of the participants may
/// lie in it. The lock (flock on the file `lock`, which names our pid) ends with the process, however that
/// ends.
class RunDirectory {
 public:
  enum class Use { new_run, resumption };

  /// Throws as the constructor would, as far as that can be told without creating or changing anything.
  static void check(const std::filesystem::path& directory);

  /// Process that holds the run in `directory`; nothing if none does. Throws Error(precondition) if there is
  /// no run directory of ours, or it cannot be read.
  static std::optional<long> holder(const std::filesystem::path& directory);

  /// Creates the directory and its parents, or takes an empty one, or one with a finished run of ours
  /// (summary.json stands), whose files it removes; foreign files in it are left alone. Locks it. Throws
  /// Error(role_taken) naming the pid if another run holds it, and Error(precondition) with what to do if it
  /// is not a directory, holds an unfinished run or files that are not ours, or cannot be created or written.
  explicit RunDirectory(const std::filesystem::path& directory);

  /// With Use::resumption: takes a directory that holds a run of ours, finished or not, and changes nothing
  /// in it but the lock. Throws Error(precondition) if there is no run, otherwise as the other constructor.
  RunDirectory(const std::filesystem::path& directory, Use use);
  ~RunDirectory();
  RunDirectory(const RunDirectory&) = delete;
  RunDirectory& operator=(const RunDirectory&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  void clear();

  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace fissura::coupler
