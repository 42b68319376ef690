// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/exchange/channel.hpp"
#include "common/exchange/message.hpp"
#include "common/exchange/stamp_check.hpp"
#include "coupler/faults/frame_link.hpp"
#include "coupler/launch/child_process.hpp"

namespace fissura::coupler {

/// What becomes of what a participant prints.
enum class Printed { shown, kept };

struct DrivenOptions {
  std::string command;  ///< shell command; `--connect ENDPOINT` is appended
  RunId run{};          ///< stamped on every message to it, and expected on every message but HELLO
  std::uint32_t epoch = 0;
  Printed printed = Printed::kept;
};

/// FAIL.
struct ToldFailure {
  Message message;
  [[nodiscard]] std::string reason() const { return message.body.value("reason", std::string("no reason")); }
  [[nodiscard]] int exit_code() const { return message.body.value("exit_code", -1); }
};
/// A message that cannot be accepted: damaged, lost, doubled, of another run.
struct Nonsense {
  std::string reason;
};
/// What a wait ends with; PROGRESS never ends one.
using Heard = std::variant<Message, ToldFailure, Nonsense, Silence, ConnectionLost, ProcessEnd>;

/// The same in words: "PRESSURE", "FAIL 22: ...", "nothing within 2 s", "its process ended with ...".
std::string in_words(const Heard& heard);
/// "ended with exit code 22 (PROTOCOL-VIOLATION)", "was killed by signal 9 (...)".
std::string in_words(const ProcessEnd& end);

struct HeardProgress {
  double time = 0;  ///< wall, since the last message that was said to it [s]
  std::string phase;
  std::optional<int> stop_signal;
};

/// One participant process without a trio: this object is its coupler. While it waits it sends PROGRESS each
/// second, as the coupler does. At its end the process is ended and the socket removed; what that process
/// started itself and left behind is for end_descendants (process_tree.hpp).
class DrivenParticipant {
 public:
  /// Starts the process. Throws Error(precondition) if there can be no socket.
  explicit DrivenParticipant(const DrivenOptions& options);
  ~DrivenParticipant();
  DrivenParticipant(const DrivenParticipant&) = delete;
  DrivenParticipant& operator=(const DrivenParticipant&) = delete;

  /// The next message but PROGRESS, or what came instead of it, within `patience`. Words come before the end
  /// of the process or connection that said them.
  Heard hear(Seconds patience);
  /// say and hear.
  Heard ask(Message command, Seconds patience);

  /// Stamps and sends. @returns false if there is nobody (any more), or the queue is full
  bool say(Message message);
  /// `message` as the next one, not yet sent; its sequence number is used up.
  Frames stamped(Message message);
  /// Sends a message that was said before, in the same run and epoch: with the next sequence number, and a
  /// checksum that fits.
  bool say_again(Frames message);
  /// Sends frames as they are.
  bool say_frames(const Frames& frames);

  /// Frames of the last message that `hear` returned.
  [[nodiscard]] const Frames& last_frames() const { return last_frames_; }
  /// Envelope fields of the same.
  [[nodiscard]] const Stamp& last_stamp() const { return last_stamp_; }
  /// All PROGRESS since the last message that was said to it.
  [[nodiscard]] const std::vector<HeardProgress>& progress() const { return progress_; }

  /// From now on no PROGRESS is sent.
  void fall_silent() { keeps_alive_ = false; }
  /// Ends the connection as a coupler that is gone does.
  void hang_up() { link_.cut(); }

  void send_signal(int signal) { process_.send_signal(signal); }
  [[nodiscard]] pid_t pid() const { return process_.pid(); }
  /// How the process ended, if it does within `patience`.
  std::optional<ProcessEnd> wait_for_end(Seconds patience);

  /// What it printed so far; empty if that is shown.
  [[nodiscard]] std::string printed() const;

 private:
  using Clock = std::chrono::steady_clock;

  /// A directory of this user's own for the socket.
  class Place {
   public:
    Place();
    ~Place();
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;
    [[nodiscard]] std::filesystem::path operator/(const char* name) const { return folder_ / name; }

   private:
    std::filesystem::path folder_;
  };

  std::optional<Heard> next_word();
  std::optional<Heard> accept(Frames&& frames);
  void note_progress_of(const Message& message);
  void keep_alive();
  [[nodiscard]] std::vector<std::string> command_line(const DrivenOptions& options) const;

  Place place_;
  DrivenOptions options_;
  FrameLink link_;
  ChildProcess process_;
  StampCheck check_;
  std::uint64_t sent_ = 0;
  bool greeted_ = false, keeps_alive_ = true;
  Clock::time_point last_said_ = Clock::now(), last_sign_ = Clock::now();
  Frames last_frames_;
  Stamp last_stamp_;
  std::vector<HeardProgress> progress_;
};

}  // namespace fissura::coupler
