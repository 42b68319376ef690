// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "coupler/launch/healing.hpp"
#include "coupler/launch/status_page.hpp"

namespace fissura::coupler {

/// One life of the worker.
struct Attempt {
  bool resumes = false;     ///< goes on from the newest whole checkpoint, or from the beginning without one
  std::uint32_t epoch = 0;  ///< how often the run has been resumed
};

struct Supervision {
  std::filesystem::path directory;  ///< of the run, claimed by this process
  double deadline = 0;              ///< wall seconds the worker may go without a beat; infinite: it may be stopped, too
  Healing healing;
  Attempt first;
};

/// Forks, runs `work` in the child (the worker, leader of its own process group) and watches it until it
/// ends. A first SIGINT, SIGTERM or SIGHUP asks the worker to end at the next coupling time, a second one
/// ends it at once; SIGUSR1 asks for a checkpoint. A worker that is killed, stopped for longer than two
/// seconds, without a beat on the page for the deadline, or still there some seconds after StatusPage::fail
/// ends this life of the run; so nothing is left of its descendants. `work` tells its failures by
/// StatusPage::fail and returns the exit code of the program.
///
/// With healing, a run whose participant or worker died, hung or broke the protocol goes on with another
/// worker, and a line on standard error says so. At the end prints the last line of a run that is not
/// complete and writes run.report.json.
/// @returns the exit code of the run: that of its first fault, whatever died of it then
int supervise(StatusPage& status, const Supervision& supervision,
              const std::function<int(const Attempt&)>& work);

}  // namespace fissura::coupler
