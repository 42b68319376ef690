// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "coupler/faults/frame_link.hpp"
#include "coupler/faults/message_fault.hpp"

namespace fissura::coupler {

/// The messages between the coupler and one participant in the order in which they passed: one JSON object on
/// each line, at once on the disk's side of this process. Nothing in it depends on time or chance, so that
/// equal runs have equal transcripts: PROGRESS stands in it only where something was done to it, a message is
/// counted by `n` in its direction without PROGRESS, and `bytes` and `crc` are of its arrays, as they came.
class Transcript {
 public:
  /// Appends to `file`. Throws Error(precondition).
  Transcript(const std::filesystem::path& file, std::uint64_t epoch);
  ~Transcript();
  Transcript(const Transcript&) = delete;
  Transcript& operator=(const Transcript&) = delete;

  /// @param did  what was done to the message; empty: it was passed on as it was
  void note(Direction direction, const Frames& message, const std::string& did);

 private:
  int descriptor_ = -1;
  std::uint64_t epoch_ = 0;
  std::array<std::uint64_t, 2> count_{};  ///< by Direction
};

}  // namespace fissura::coupler
