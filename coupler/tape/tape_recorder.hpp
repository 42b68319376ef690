// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "common/exchange/channel.hpp"
#include "coupler/tape/tape_writer.hpp"

namespace fissura::coupler {

/// Tapes what passes on the coupler's channel between it and the participants of `roles`. Who plays a role is
/// known when its HELLO is answered by WELCOME; strangers leave nothing.
class TapeRecorder : public FrameObserver {
 public:
  /// Creates RUN/tape if there is a role to tape. Throws StorageError.
  TapeRecorder(const std::filesystem::path& run_directory, std::set<Role> roles, const RunId& run,
               std::uint32_t epoch);

  void sent(PeerNumber peer, FrameViews frames) override;
  void received(PeerNumber peer, FrameViews frames) override;

  /// Waits until the disk has all tapes. Throws StorageError.
  void sync();

 private:
  using Clock = std::chrono::steady_clock;
  /// HELLO of somebody who has not been answered.
  struct Greeting {
    PeerNumber peer = 0;
    double time = 0;
    Frames frames;
  };

  [[nodiscard]] double now() const;
  void begin_tape(PeerNumber peer, const Greeting& greeting);

  std::filesystem::path run_directory_;
  std::set<Role> roles_;
  RunId run_;
  std::uint32_t epoch_;
  double started_utc_;
  Clock::time_point started_ = Clock::now();
  std::optional<Greeting> greeting_;
  std::map<PeerNumber, TapeWriter> tapes_;
};

}  // namespace fissura::coupler
