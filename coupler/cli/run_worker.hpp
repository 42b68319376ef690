// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupler/cli/run_command.hpp"
#include "coupler/launch/status_page.hpp"

namespace fissura::coupler {

/// The run itself, in the supervisor's child: starts the trio, runs the scheme, judges, writes the summary. Every failure is told to the
/// participants, written to the record and left on the status page for the last line. @returns the exit code of the program
int run_worker(const PreparedRun& run, StatusPage& status);

}  // namespace fissura::coupler
