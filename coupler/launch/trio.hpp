// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/case/case.hpp"
#include "common/exchange/channel.hpp"
#include "common/exchange/participant.hpp"
#include "coupler/launch/child_process.hpp"
#include "coupler/launch/status_page.hpp"

namespace fissura::coupler {

/// The first fault of a run: who, when, why.
struct ParticipantFailure : Error {
  ParticipantFailure(ExitCode code, Role failed_role, const std::string& sentence)
      : Error(code, sentence), role(failed_role) {}
  Role role;
};

struct TrioOptions {
  std::string endpoint;                   ///< to bind, ipc://... or tcp://127.0.0.1:*
  /// Shell command of each Role; `--connect ENDPOINT` is appended. Nothing: somebody else starts that participant, and it is awaited.
  std::array<std::optional<std::string>, 2> command;
  int threads = 1;                        ///< of the structure
  Deadlines deadlines;
};

/// Where a run begins: at time 0, or at a checkpoint that RESTORE brings next.
enum class Start { fresh, resuming };

/// What a participant said of itself.
struct ParticipantIdentity {
  std::string solver, version;
  long pid = 0;
};

/// The coupler's two participants: started, greeted, asked, watched, ended. Every wait ends: with the answer, or with a
/// ParticipantFailure naming the participant, what it was asked, and the cause.
class Trio {
 public:
  /// @param epoch  how often the run has been resumed
  Trio(const TrioOptions& options, const RunId& run, std::uint32_t epoch, StatusPage& status);
  ~Trio();

  /// Starts or awaits both participants and gives them the case. Returns when both have said HELLO. Next comes, from Start::fresh, the
  /// structure's TOPOLOGY; from Start::resuming, RESTORE to both.
  void start(const nlohmann::json& run_case, Start start);

  [[nodiscard]] const ParticipantIdentity& identity(Role role) const { return participant(role).identity; }

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
    std::optional<ChildProcess> process;
    std::optional<PeerNumber> peer;
    ParticipantIdentity identity;
    std::optional<Message> answer;
    std::string asked = "HELLO";              ///< what it was asked last
    std::uint64_t interval = 0;
    std::string phase = "start";              ///< as of its last PROGRESS
    Clock::time_point last_word{};
    std::optional<Clock::time_point> stopped_since;
    bool said_bye = false;
    double waited = 0;
  };

  Participant& participant(Role role) { return participants_[static_cast<std::size_t>(role)]; }
  [[nodiscard]] const Participant& participant(Role role) const {
    return participants_[static_cast<std::size_t>(role)];
  }

  void handle_next_event(Seconds patience);
  void handle(CouplerChannel::Received&& received);
  void hear_stop_request(const Participant& participant, const Message& progress);
  void greet(PeerNumber peer, const Message& hello);
  void reject(PeerNumber peer, const std::string& reason);
  void watch_processes();
  void hear_last_words();
  void check_silence(Participant& waiting_for, double deadline);
  void keep_alive();
  [[nodiscard]] std::string situation(const Participant& participant) const;
  [[noreturn]] void fail(ExitCode code, const Participant& participant, const std::string& cause);

  TrioOptions options_;
  StatusPage& status_;
  CouplerChannel channel_;
  std::array<Participant, 2> participants_;
  nlohmann::json run_case_;
  Start start_ = Start::fresh;
  std::string run_id_;
  Clock::time_point next_keep_alive_{};
  bool ending_ = false;
};

}  // namespace fissura::coupler
