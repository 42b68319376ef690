// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

#include "coupler/record/checked_file.hpp"

namespace fissura::coupler {

enum class EventLevel { debug, info, warn, error };

/// One thing that happened in a run.
struct Event {
  std::uint64_t interval = 0;  ///< coupling index it belongs to
  double time = 0;             ///< simulated [s]
  EventLevel level = EventLevel::info;
  std::string participant;  ///< "coupler", "structure" or "network"
  std::string event;        ///< a fixed word, e.g. "topology"
  std::string text;         ///< one sentence
};

/// log.jsonl: one JSON object per line with `interval`, `time` [s], `wall` (seconds since the log was
/// opened, anew when a run goes on), `level`, `participant`, `event`, `text`. Every event is handed to the
/// system at once, so that it survives our own death.
class EventLog {
 public:
  /// Creates the file, or goes on behind the last whole line of one that is there. Throws StorageError.
  explicit EventLog(const std::filesystem::path& file);

  /// Throws StorageError.
  void add(const Event& event);

 private:
  CheckedFile file_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace fissura::coupler
