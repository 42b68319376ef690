// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/memory_kills.hpp"

#include <unistd.h>

#include <fstream>
#include <string>

namespace fissura::coupler {

namespace {

std::optional<std::uint64_t> count_in(const std::string& file) {
  std::ifstream events(file);
  std::string key;
  for (std::uint64_t count = 0; events >> key >> count;)
    if (key == "oom_kill") return count;
  return std::nullopt;
}

/// Where the kernel counts them, in the first or the second version of control groups.
std::string events_file(pid_t process) {
  std::ifstream groups("/proc/" + std::to_string(process) + "/cgroup");
  const std::string unified = "0::", memory = ":memory:";
  std::string file;
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first_version = line.find(memory);
    if (first_version != std::string::npos)
      return "/sys/fs/cgroup/memory" + line.substr(first_version + memory.size()) + "/memory.oom_control";
    if (line.starts_with(unified)) file = "/sys/fs/cgroup" + line.substr(unified.size()) + "/memory.events";
  }
  return file;
}

}  // namespace

std::optional<std::uint64_t> memory_kills() {
  return count_in(events_file(::getpid()));
}

MemoryKillWatch::MemoryKillWatch(pid_t process) : file_(events_file(process)), before_(count_in(file_)) {}

bool MemoryKillWatch::has_seen_one() const {
  const std::optional<std::uint64_t> now = count_in(file_);
  return now && before_ && *now > *before_;
}

}  // namespace fissura::coupler
