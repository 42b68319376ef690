// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <optional>

namespace fissura {

/// Keeps these signals waiting for held_signal() instead of letting them end or interrupt this process; those
/// that were ignored when the program started stay ignored. To be called before any thread is started.
void hold_signals(std::initializer_list<int> signals);

/// The next signal that is waiting, if there is one. Cheap.
std::optional<int> held_signal();

/// Whether this process was told to ignore `signal`, as a program under nohup is.
bool is_ignored(int signal);

}  // namespace fissura
