// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace fissura::log {

/// Starts the log of this process on standard error; every line carries `participant`.
/// `level` is one of "debug", "info", "warn", "error"; anything else throws InputError.
void start(std::string_view participant, std::string_view level = "info");

void debug(const std::string& line);
void info(const std::string& line);
void warn(const std::string& line);
void error(const std::string& line);

}  // namespace fissura::log
