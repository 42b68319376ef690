// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "coupler/launch/child_process.hpp"

namespace fissura::bench {

/// Runs `work` in a process of its own. Call it before the caller has threads.
coupler::ChildProcess forked_peer(const std::function<void()>& work);

}  // namespace fissura::bench
