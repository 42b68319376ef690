// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>

namespace fissura::coupler {

/// The file in which the kernel counts the processes that it has killed for want of memory, for the control
/// groups in `groups`, the text of /proc/PID/cgroup; empty if there is none.
std::string memory_events_file(const std::string& groups);

/// The count `oom_kill` in such a file; nothing if it is not there or tells none.
std::optional<std::uint64_t> memory_kills_in(const std::string& file);

/// How many processes the kernel has killed for want of memory in the control group of this process; nothing
/// where the kernel does not tell.
std::optional<std::uint64_t> memory_kills();

/// Whether the kernel has killed for want of memory since this object was made, in the control group that
/// `process` was in then.
class MemoryKillWatch {
 public:
  explicit MemoryKillWatch(pid_t process);
  [[nodiscard]] bool has_seen_one() const;

 private:
  std::string file_;
  std::optional<std::uint64_t> before_;
};

}  // namespace fissura::coupler
