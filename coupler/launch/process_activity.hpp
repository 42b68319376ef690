// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

namespace fissura::coupler {

/// What the system says of a process.
struct ProcessActivity {
  char state = '?';          ///< of its main thread, as in proc(5): R runs, S sleeps, D waits for a device, T
                             ///< stopped, t traced
  double cpu_seconds = 0;    ///< used so far by all of its threads [s]
  std::string wait_channel;  ///< place in the kernel where it sleeps; empty if it does not, or the system
                             ///< does not tell
};

/// Nothing if there is no such process.
std::optional<ProcessActivity> activity_of(pid_t process);

/// The debugger, or whoever else, that traces a process; nothing if nobody does or there is no such process.
std::optional<pid_t> tracer_of(pid_t process);

/// "runs (state R), 1.98 s of CPU time in the last 2.00 s", "sleeps (state S) in futex_wait_queue, ...".
/// @param earlier  the same process `seconds` before
std::string describe(const ProcessActivity& now, const ProcessActivity& earlier, double seconds);

}  // namespace fissura::coupler
