// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>

/// A disk that loses power. The program is linked so that its calls of fsync and rename come here first.
namespace fissura::coupler::sample {

/// What becomes of what was not synced.
enum class Loss {
  everything,  ///< contents and names are as of the last fsync of each file and each folder
  contents     ///< names are as they are, contents as of the last fsync: files without content appear
};

/// Keeps account of what the disk surely has of the folder `root`, from now on, and calls `power_fails`
/// before and after every call that syncs or renames something.
class UnsyncedDisk {
 public:
  UnsyncedDisk(std::filesystem::path root, std::function<void()> power_fails);
  ~UnsyncedDisk();
  UnsyncedDisk(const UnsyncedDisk&) = delete;
  UnsyncedDisk& operator=(const UnsyncedDisk&) = delete;

  /// Makes the new folder `copy` what would be found of `root` if the power failed now.
  void leave_behind(Loss loss, const std::filesystem::path& copy) const;
};

}  // namespace fissura::coupler::sample
