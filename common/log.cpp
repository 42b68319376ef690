// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/log.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "common/errors.hpp"

namespace fissura::log {

void start(std::string_view participant, std::string_view level) {
  const auto threshold = spdlog::level::from_str(std::string(level));
  if (threshold == spdlog::level::off) throw InputError("unknown log level: " + std::string(level));
  spdlog::set_default_logger(
      std::make_shared<spdlog::logger>(std::string(participant), std::make_shared<spdlog::sinks::stderr_color_sink_mt>()));
  spdlog::set_pattern("%n: %^%l%$: %v");
  spdlog::set_level(threshold);
  spdlog::flush_on(spdlog::level::info);
}

void debug(const std::string& line) { spdlog::debug("{}", line); }
void info(const std::string& line) { spdlog::info("{}", line); }
void warn(const std::string& line) { spdlog::warn("{}", line); }
void error(const std::string& line) { spdlog::error("{}", line); }

}  // namespace fissura::log
