// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "common/exchange/channel.hpp"
#include "coupler/tape/tape.hpp"

namespace fissura::coupler {

/// Writes one tape. A message is with the system before `write` returns, by one call and without waiting for
/// the disk, so that a process that is killed loses at most the message it was writing. All functions throw
/// StorageError; a tape on which a write failed takes nothing more.
class TapeWriter {
 public:
  /// Creates `file`, or empties it.
  TapeWriter(std::filesystem::path file, const TapeHeader& header);
  ~TapeWriter();
  TapeWriter(TapeWriter&& other) noexcept;
  TapeWriter& operator=(TapeWriter&&) = delete;

  /// @param time  wall [s since the header's `started`]
  void write(Direction direction, double time, FrameViews frames);

  /// Waits until the disk has everything.
  void sync();

 private:
  void put(FrameViews pieces);

  std::filesystem::path file_;
  int descriptor_ = -1;
  bool failed_ = false;
};

}  // namespace fissura::coupler
