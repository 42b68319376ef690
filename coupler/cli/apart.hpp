// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace fissura::coupler {

/// What `look` returns, called in a process of its own: libraries may crash over a damaged file. Nothing if
/// that process died or took longer than a minute. @pre the caller has one thread
std::optional<std::string> look_apart(const std::function<std::string()>& look);

}  // namespace fissura::coupler
