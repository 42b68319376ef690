// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "coupler/launch/status_page.hpp"

namespace fissura::coupler {

/// Forks, runs `work` in the child (the worker, leader of its own process group) and watches it until it ends. A first SIGINT, SIGTERM or
/// SIGHUP asks the worker to end at the next coupling time, a second one ends it at once. A worker that is killed, stopped for longer
/// than two seconds, or without a beat on the page for `deadline` wall seconds ends the run; so nothing is left of its group.
/// @returns the exit code of the run
int supervise(StatusPage& status, double deadline, const std::function<int()>& work);

/// The last line of a failed run on standard error:  coupler: CODE-NAME who interval=K phase=P: sentence
void print_last_line(int exit_code, const char* who, std::uint64_t interval, const char* phase,
                     const char* sentence);

}  // namespace fissura::coupler
