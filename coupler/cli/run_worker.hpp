// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupler/cli/prepared_run.hpp"
#include "coupler/launch/supervisor.hpp"

namespace fissura::coupler {

/// The run itself, in the supervisor's child: starts the trio, runs the scheme from the beginning or from the
/// newest whole checkpoint, judges, writes the summary. Every failure is told to the participants, written to
/// the record and left on the status page.
/// @returns the exit code of the program
int run_worker(const PreparedRun& run, const Attempt& attempt, StatusPage& status);

}  // namespace fissura::coupler
