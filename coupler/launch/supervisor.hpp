// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "coupler/launch/status_page.hpp"

namespace fissura::coupler {

/// One life of the worker.
struct Attempt {
  bool resumes = false;     ///< goes on from the newest whole checkpoint, or from the beginning without one
  std::uint32_t epoch = 0;  ///< how often the run has been resumed
};

/// When the supervisor lets the run go on after a death.
struct Healing {
  bool wanted = false;
  int deaths_at_one_place = 3;  ///< so many without a checkpoint between them, and it gives up
};

struct Supervision {
  std::filesystem::path directory;  ///< of the run, claimed by this process
  double deadline = 0;              ///< wall seconds the worker may go without a beat
  Healing healing;
  Attempt first;
};

/// Forks, runs `work` in the child (the worker, leader of its own process group) and watches it until it
/// ends. A first SIGINT, SIGTERM or SIGHUP asks the worker to end at the next coupling time, a second one
/// ends it at once; SIGUSR1 asks for a checkpoint. A worker that is killed, stopped for longer than two
/// seconds, or without a beat on the page for the deadline ends the run; so nothing is left of its group.
/// With healing, a run whose participant or worker died, hung or broke the protocol goes on with another
/// worker. At the end prints the last line of a run that failed and writes run.report.json.
/// @returns the exit code of the run
int supervise(StatusPage& status, const Supervision& supervision,
              const std::function<int(const Attempt&)>& work);

/// The last line of a failed run on standard error:  coupler: CODE-NAME who interval=K phase=P: sentence
void print_last_line(int exit_code, const char* who, std::uint64_t interval, const char* phase,
                     const char* sentence);

}  // namespace fissura::coupler
