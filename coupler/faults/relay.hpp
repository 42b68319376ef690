// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "coupler/faults/frame_link.hpp"
#include "coupler/faults/message_fault.hpp"

namespace fissura::coupler {

/// Receives every message as it came and what was done to it; see Transcript::note.
using MessageNote = std::function<void(Direction, const Frames&, const std::string& did)>;

/// What becomes of the messages between the coupler and one participant. Knows no socket; times are seconds
/// of any clock, and only delays depend on them.
class Relay {
 public:
  /// @param faults  of this participant, in this epoch
  Relay(std::vector<MessageFault> faults, MessageNote note);

  /// A message came at time `now`.
  void take(Direction direction, Frames message, double now);
  /// The next message to send on in that direction, if its time has come.
  std::optional<Frames> next(Direction direction, double now);
  /// When next() will have something; nothing if it does not depend on time.
  [[nodiscard]] std::optional<double> next_time() const;
  /// The connections are to be cut.
  [[nodiscard]] bool is_cut() const { return cut_; }

 private:
  struct CountedFault {
    MessageFault fault;
    std::uint64_t fitting = 0;
  };
  struct Waiting {
    Frames message;
    double ready = 0;
  };
  struct Line {
    std::deque<Waiting> waiting;
    std::optional<Frames> held_back;  ///< by swap
    std::deque<Frames> past;          ///< for replay
    double blocked_until = 0;
    double bytes_per_second = 0;  ///< 0: as fast as it can
    bool deaf = false;
  };

  Line& line(Direction direction) { return lines_[static_cast<std::size_t>(direction)]; }
  [[nodiscard]] std::vector<const MessageFault*> due(Direction direction, const Frames& message);
  std::string strike(const MessageFault& fault, Direction direction, std::vector<Frames>& outgoing,
                     double now);
  bool forge(const MessageFault& fault, const Line& line, Frames& message) const;
  void enqueue(Line& line, Frames message, double now);

  std::vector<CountedFault> faults_;
  MessageNote note_;
  std::array<Line, 2> lines_;
  std::size_t remembered_ = 0;  ///< messages kept for replay
  bool cut_ = false;
};

}  // namespace fissura::coupler
