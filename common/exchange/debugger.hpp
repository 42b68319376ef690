// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A debugger may hold a process of the trio for any time: its transport must not take that for its end.
/// Those who start a trio for a debugger say so in the environment, which every process of it inherits.
namespace fissura {

/// Sets FISSURA_DEBUG_ATTACH for this process and its children.
void announce_debugger();

/// Whether that is set: then connections have no heartbeat.
bool may_be_held();

}  // namespace fissura
