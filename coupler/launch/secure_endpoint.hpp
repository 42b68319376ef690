// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace fissura::coupler {

/// Whether only processes of this machine reach `endpoint`: "ipc", ipc://..., or TCP on a loopback address.
bool is_local(const std::string& endpoint);

/// Throws Error(security), saying what to do, if `endpoint` can be reached from elsewhere and there are no
/// keys.
enum class Keys { present, absent };
void require_keys(const std::string& endpoint, Keys keys);

/// Raises the soft limit of open files, as far as allowed, to what a run with many strangers at its door may
/// need.
void raise_limit_of_open_files();

}  // namespace fissura::coupler
