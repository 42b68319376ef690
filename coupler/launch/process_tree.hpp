// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <set>

namespace fissura::coupler {

/// Every process that descends from this one, in whatever group or session it is now; without ended ones.
std::set<pid_t> descendants();

/// Kills and reaps every descendant but `spared` and what descends from those. Orphans are found too if this
/// process is a subreaper. Also ends children that are forked while it is at work.
/// @returns whether all are gone; they may not be after two seconds if the kernel holds one
bool end_descendants(const std::set<pid_t>& spared);

}  // namespace fissura::coupler
