// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/memory_kills.hpp"

#include <fstream>
#include <string>

namespace fissura::coupler {

std::optional<std::uint64_t> memory_kills() {
  std::ifstream groups("/proc/self/cgroup");
  const std::string unified = "0::";
  for (std::string line; std::getline(groups, line);) {
    if (!line.starts_with(unified)) continue;
    std::ifstream events("/sys/fs/cgroup" + line.substr(unified.size()) + "/memory.events");
    std::string key;
    for (std::uint64_t count = 0; events >> key >> count;)
      if (key == "oom_kill") return count;
  }
  return std::nullopt;
}

}  // namespace fissura::coupler
