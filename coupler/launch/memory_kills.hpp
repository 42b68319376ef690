// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>

namespace fissura::coupler {

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
