// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace fissura {

/// From now on SIGUSR2 makes this process print the call stack of its main thread on standard error and go
/// on.
void dump_stack_on_request();

/// Whether dump_stack_on_request was called.
bool dumps_stack();

}  // namespace fissura
