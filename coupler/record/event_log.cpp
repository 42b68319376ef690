// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/event_log.hpp"

#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "common/hash.hpp"

namespace fissura::coupler {

namespace {

const char* name(EventLevel level) {
  switch (level) {
    case EventLevel::debug:
      return "debug";
    case EventLevel::info:
      return "info";
    case EventLevel::warn:
      return "warn";
    case EventLevel::error:
      return "error";
  }
  return "unknown";
}

CheckedFile behind_last_line(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return CheckedFile(file);
  const std::string text = read_whole_file(file);
  const std::string_view whole = std::string_view(text).substr(0, text.rfind('\n') + 1);
  return {file, {whole.size(), crc32(std::as_bytes(std::span(whole)))}};
}

}  // namespace

EventLog::EventLog(const std::filesystem::path& file)
    : file_(behind_last_line(file)), start_(std::chrono::steady_clock::now()) {}

void EventLog::add(const Event& event) {
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start_;
  nlohmann::ordered_json line;
  line["interval"] = event.interval;
  line["time"] = event.time;
  line["wall"] = wall.count();
  line["level"] = name(event.level);
  line["participant"] = event.participant;
  line["event"] = event.event;
  line["text"] = event.text;
  // Texts come from other processes too: bytes that are not UTF-8 are replaced, not fatal.
  file_.append(line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
  file_.flush();
}

}  // namespace fissura::coupler
