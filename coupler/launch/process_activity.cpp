// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/process_activity.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

namespace fissura::coupler {

namespace {

const char* verb(char state) {
  switch (state) {
    case 'R':
      return "runs";
    case 'S':
      return "sleeps";
    case 'D':
      return "waits for a device";
    case 'T':
      return "is stopped";
    case 't':
      return "is held by a debugger";
    case 'Z':
      return "has ended";
    default:
      return "is";
  }
}

}  // namespace

std::optional<ProcessActivity> activity_of(pid_t process) {
  const std::string folder = fmt::format("/proc/{}/", process);
  std::ifstream file(folder + "stat");
  std::string text;
  if (!std::getline(file, text)) return std::nullopt;
  const std::size_t name_end = text.rfind(')');  // the name may hold anything
  if (name_end == std::string::npos) return std::nullopt;
  std::istringstream fields(text.substr(name_end + 1));
  ProcessActivity activity;
  fields >> activity.state;
  constexpr int fields_before_utime = 10;
  std::string skipped;
  for (int i = 0; i < fields_before_utime; ++i) fields >> skipped;
  double user_ticks = 0, system_ticks = 0;
  if (!(fields >> user_ticks >> system_ticks)) return std::nullopt;
  activity.cpu_seconds = (user_ticks + system_ticks) / static_cast<double>(::sysconf(_SC_CLK_TCK));
  std::ifstream wait_channel(folder + "wchan");
  std::getline(wait_channel, activity.wait_channel);
  if (activity.wait_channel == "0") activity.wait_channel.clear();
  return activity;
}

std::optional<pid_t> tracer_of(pid_t process) {
  const std::string entry = "TracerPid:";
  std::ifstream file(fmt::format("/proc/{}/status", process));
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(entry)) {
      pid_t tracer = 0;
      std::istringstream(line.substr(entry.size())) >> tracer;
      return tracer > 0 ? std::optional(tracer) : std::nullopt;
    }
  return std::nullopt;
}

std::string describe(const ProcessActivity& now, const ProcessActivity& earlier, double seconds) {
  return fmt::format("{} (state {}){}{}, {:.2f} s of CPU time in the last {:.2f} s", verb(now.state),
                     now.state, now.wait_channel.empty() ? "" : " in ", now.wait_channel,
                     now.cpu_seconds - earlier.cpu_seconds, seconds);
}

}  // namespace fissura::coupler
