// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "common/case/case.hpp"
#include "common/exchange/channel.hpp"
#include "common/exchange/participant.hpp"
#include "common/exchange/protocol_table.hpp"
#include "coupler/launch/child_process.hpp"
#include "coupler/launch/death_watch.hpp"
#include "coupler/launch/memory_kills.hpp"
#include "coupler/launch/process_activity.hpp"
#include "coupler/launch/progress_ladder.hpp"
#include "coupler/launch/status_page.hpp"

namespace fissura::coupler {

/// The first fault of a run: who, when, why.
struct ParticipantFailure : Error {
  ParticipantFailure(ExitCode code, Role failed_role, const std::string& sentence)
      : Error(code, sentence), role(failed_role) {}
  Role role;
};

/// Told of what does not end a run: `event` is "stopped", "no progress", "diagnosis" or "refused".
using TrioWarning = std::function<void(Role role, const char* event, const std::string& text)>;

struct TrioOptions {
  Listening listening;  ///< where participants connect, and with which keys
  /// Shell command of each Role; `more_words` and `--connect ENDPOINT` are appended. Nothing: somebody else
  /// starts that participant, and it is awaited.
  std::array<std::optional<std::string>, 2> command;
  int threads = 1;  ///< of the structure
  Deadlines deadlines;
  bool debug_attach =
      false;  ///< a debugger may hold a participant: neither silence nor being stopped ends the run
  std::string more_words = {};  ///< of every command, e.g. " --keys 'DIR'"
  TrioWarning on_warning = {};  ///< without it warnings go to the log
  FrameObserver* observer = nullptr;  ///< sees every message, if there is one; outlives the trio
};

/// Where a run begins: at time 0, or at a checkpoint that RESTORE brings next.
enum class Start { fresh, resuming };

/// What a participant said of itself.
struct ParticipantIdentity {
  std::string solver, version;
  long pid = 0;
  std::set<std::string, std::less<>> capabilities;
};

/// The coupler's two participants: started, greeted, asked, watched, ended. Every wait ends: with the answer,
/// or with a ParticipantFailure naming the participant, what it was asked, and the cause. What may be said
/// when, and what follows from what is heard, is looked up in protocol_table.hpp. What is known of the
/// participants is shown on the status page.
class Trio {
 public:
  /// @param epoch  how often the run has been resumed
  Trio(const TrioOptions& options, const RunId& run, std::uint32_t epoch, StatusPage& status);
  ~Trio();

  /// Starts or awaits both participants and gives them the case. Returns when both have said HELLO. Next
  /// comes, from Start::fresh, the structure's TOPOLOGY; from Start::resuming, RESTORE to both.
  void start(const nlohmann::json& run_case, Start start);

  [[nodiscard]] const ParticipantIdentity& identity(Role role) const { return participant(role).identity; }
  /// Whether the participant said in HELLO that it can do this, e.g. "save".
  [[nodiscard]] bool can(Role role, std::string_view capability) const {
    return participant(role).identity.capabilities.contains(capability);
  }

  /// Throws Error(internal) if the protocol does not allow `command` now.
  void send(Role role, Message command);
  /// The answer to the last command sent to `role`.
  Message await(Role role, MessageType expected);
  Message request(Role role, Message command, MessageType expected);

  /// FINISH to both; returns their figures. Both processes have ended afterwards.
  std::array<nlohmann::json, 2> finish();

  /// Tells both participants why the run ends and ends them.
  void abort(const std::string& reason);

  /// Wall time spent waiting for answers of `role` [s].
  [[nodiscard]] double waited(Role role) const { return participant(role).waited; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Participant {
    Role role = Role::structure;
    CouplerView view = CouplerView::absent;
    std::optional<ChildProcess> process;  ///< if it was started here
    std::optional<MemoryKillWatch> memory;
    std::optional<PeerNumber> peer;
    ParticipantIdentity identity;
    std::optional<Message> answer;
    std::string asked = "HELLO";  ///< what it was asked last
    std::uint64_t interval = 0, revision = 0;  ///< of that command
    std::string phase = "start";  ///< as of its last PROGRESS, or with which it begins the command
    std::uint64_t count = 0;
    Clock::time_point asked_at{}, last_word{}, joined{};
    std::optional<Clock::time_point> stopped_since;
    ProgressLadder ladder{0};
    std::optional<ProcessActivity> activity_when_warned;
    Clock::time_point warned_at{};
    std::optional<Error> refusal;  ///< why somebody was refused before this one introduced itself
    double waited = 0;
  };

  Participant& participant(Role role) { return participants_[static_cast<std::size_t>(role)]; }
  [[nodiscard]] const Participant& participant(Role role) const {
    return participants_[static_cast<std::size_t>(role)];
  }

  void start_process(Participant& each);
  static void require_allowed(const Participant& target, Word word);
  void say(Participant& target, Message message);

  void handle_next_event(Seconds patience);
  bool handle(CouplerChannel::Event&& event);
  void hear(Participant& each, Message&& message);
  void take(Participant& each, CouplerView asked_in, Message&& answer);
  void hear_progress(Participant& each, const Message& message);
  void hear_stop_request(const Participant& participant, const Message& progress);
  [[noreturn]] void hear_failure(Participant& each, const Message& message);
  void hear_stranger(const CouplerChannel::Received& received);
  void greet(PeerNumber peer, Participant& each, const Message& hello);
  [[nodiscard]] std::optional<std::string> unclaimed_physics(Role role, const Message& hello) const;
  void refuse(PeerNumber peer, ExitCode code, const std::string& reason, const nlohmann::json& hello);
  void peer_lost(Participant& each, Loss how);

  void watch_processes();
  [[noreturn]] void process_ended(Participant& each);
  void watch_stop(Participant& each);
  void hear_last_words(const Participant& each);
  void watch_silence(Participant& each);
  void climb_ladder(Participant& each, double silent_seconds);
  [[nodiscard]] std::string activity(const Participant& each) const;
  static std::string refusal_in_words(const Participant& each);
  [[nodiscard]] bool dump_stack(const Participant& each) const;
  void wait_for_end(Participant& each);
  void keep_alive();
  void show(const Participant& each);

  void warn(const Participant& each, const char* event, const std::string& text) const;
  [[nodiscard]] std::string situation(const Participant& participant) const;
  [[noreturn]] void fail(ExitCode code, const Participant& participant, const std::string& cause);

  TrioOptions options_;
  StatusPage& status_;
  CouplerChannel channel_;
  DeathWatch deaths_;
  std::array<Participant, 2> participants_;
  nlohmann::json run_case_;
  Start start_ = Start::fresh;
  std::string run_id_;
  Clock::time_point next_keep_alive_{}, next_stop_watch_{};
};

}  // namespace fissura::coupler
