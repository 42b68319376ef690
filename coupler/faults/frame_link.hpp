// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fissura::coupler {

/// A message as it goes over the wire; nothing in it is checked.
using Frames = std::vector<std::vector<std::byte>>;

/// One end of a connection that carries frames as they are: the second door to ZeroMQ, beside
/// common/exchange/channel, because it must carry what a channel refuses. It notices a lost peer as a channel
/// does.
class FrameLink {
 public:
  /// Connects to `endpoint` as a participant does.
  static FrameLink connected(const std::string& endpoint);
  /// Waits for one peer at `endpoint` as a coupler does.
  static FrameLink listening(const std::string& endpoint);
  ~FrameLink();
  FrameLink(FrameLink&&) noexcept;
  FrameLink& operator=(FrameLink&&) = delete;

  /// Whether the frames went on their way; not if there is no peer, or its queue is full.
  bool send(const Frames& frames);
  /// What has come, if anything has.
  std::optional<Frames> receive();
  /// Whether the connection broke; what came before can still be received.
  bool lost();
  /// Ends the connection after what was sent is with the peer, or at most a second.
  void close();
  /// Ends the connection now.
  void cut();

 private:
  friend void wait_for_any(FrameLink& first, FrameLink& second, int descriptor,
                           std::chrono::milliseconds longest);
  friend void wait_for(FrameLink& link, int descriptor, std::chrono::milliseconds longest);
  class Implementation;
  explicit FrameLink(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

/// Returns when something has come on a link, a link broke, `descriptor` is readable, or after `longest`.
void wait_for_any(FrameLink& first, FrameLink& second, int descriptor, std::chrono::milliseconds longest);

/// The same for one link; without a descriptor if that is negative.
void wait_for(FrameLink& link, int descriptor, std::chrono::milliseconds longest);

}  // namespace fissura::coupler
