// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/process_tree.hpp"

#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <charconv>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>

namespace fissura::coupler {

namespace {

constexpr int attempts = 400;
constexpr useconds_t pause_between = 5000;

/// Parent of a process that has not ended.
std::optional<pid_t> parent_of(const std::string& pid) {
  std::ifstream stream("/proc/" + pid + "/stat");
  std::string text;
  std::getline(stream, text);
  const std::size_t name_end = text.rfind(')');  // the name may hold anything
  if (name_end == std::string::npos || name_end + 4 >= text.size() || text[name_end + 2] == 'Z')
    return std::nullopt;
  pid_t parent = 0;
  const char* begin = text.data() + name_end + 4;
  if (std::from_chars(begin, text.data() + text.size(), parent).ec != std::errc()) return std::nullopt;
  return parent;
}

std::multimap<pid_t, pid_t> children_by_parent() {
  std::multimap<pid_t, pid_t> children;
  std::error_code ended;
  for (std::filesystem::directory_iterator entry("/proc", ended), last; !ended && entry != last;
       entry.increment(ended)) {
    const std::string text = entry->path().filename().string();
    pid_t pid = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), pid).ptr != text.data() + text.size())
      continue;
    if (const std::optional<pid_t> parent = parent_of(text)) children.emplace(*parent, pid);
  }
  return children;
}

void collect(const std::multimap<pid_t, pid_t>& children, pid_t parent, const std::set<pid_t>& spared,
             std::set<pid_t>& found) {
  const auto [first, last] = children.equal_range(parent);
  for (auto child = first; child != last; ++child)
    if (!spared.contains(child->second) && found.insert(child->second).second)
      collect(children, child->second, spared, found);
}

std::set<pid_t> descendants_but(const std::set<pid_t>& spared) {
  std::set<pid_t> found;
  collect(children_by_parent(), ::getpid(), spared, found);
  return found;
}

/// The number may have gone to another process since it was listed: the descriptor holds the process itself.
void kill_if_ours(pid_t pid, const std::set<pid_t>& listed) {
  const int descriptor = static_cast<int>(::syscall(SYS_pidfd_open, pid, 0));
  if (descriptor < 0) return;
  const std::optional<pid_t> parent = parent_of(std::to_string(pid));
  if (parent && (*parent == ::getpid() || listed.contains(*parent)))
    ::syscall(SYS_pidfd_send_signal, descriptor, SIGKILL, nullptr, 0);
  ::close(descriptor);
}

}  // namespace

std::set<pid_t> descendants() {
  return descendants_but({});
}

bool end_descendants(const std::set<pid_t>& spared) {
  for (int attempt = 0; attempt < attempts; ++attempt) {
    while (::waitpid(-1, nullptr, WNOHANG) > 0) {
    }
    const std::set<pid_t> found = descendants_but(spared);
    if (found.empty()) return true;
    for (const pid_t pid : found) kill_if_ours(pid, found);
    ::usleep(pause_between);
  }
  return false;
}

}  // namespace fissura::coupler
