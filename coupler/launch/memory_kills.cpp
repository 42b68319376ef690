// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/memory_kills.hpp"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

namespace fissura::coupler {

namespace {

std::string events_file_of(pid_t process) {
  std::ifstream groups("/proc/" + std::to_string(process) + "/cgroup");
  return memory_events_file({std::istreambuf_iterator<char>(groups), {}});
}

}  // namespace

std::string memory_events_file(const std::string& groups) {
  const std::string unified = "0::", memory = ":memory:";
  std::string file;
  std::istringstream lines(groups);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first_version = line.find(memory);
    if (first_version != std::string::npos)
      return "/sys/fs/cgroup/memory" + line.substr(first_version + memory.size()) + "/memory.oom_control";
    if (line.starts_with(unified)) file = "/sys/fs/cgroup" + line.substr(unified.size()) + "/memory.events";
  }
  return file;
}

std::optional<std::uint64_t> memory_kills_in(const std::string& file) {
  std::ifstream events(file);
  std::string key;
  for (std::uint64_t count = 0; events >> key >> count;)
    if (key == "oom_kill") return count;
  return std::nullopt;
}

std::optional<std::uint64_t> memory_kills() {
  return memory_kills_in(events_file_of(::getpid()));
}

MemoryKillWatch::MemoryKillWatch(pid_t process)
    : file_(events_file_of(process)), before_(memory_kills_in(file_)) {}

bool MemoryKillWatch::has_seen_one() const {
  const std::optional<std::uint64_t> now = memory_kills_in(file_);
  return now && before_ && *now > *before_;
}

}  // namespace fissura::coupler
