// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "common/errors.hpp"
#include "common/exchange/channel.hpp"
#include "common/exchange/participant.hpp"
#include "common/exchange/protocol_table.hpp"
#include "common/faults/fault_point.hpp"
#include "common/fracture_network/fracture_network.hpp"

namespace fissura {

/// One participant's part in one run, from HELLO to the end of its connection. What follows from a message is
/// looked up in protocol_table.hpp.
class Session {
 public:
  Session(Role role, const ParticipantOptions& options, Solver& solver);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// @returns the exit code of the process; every failure has been told and printed
  int run();

 private:
  void greet();
  Message next_message();
  void hear_coupler();
  void pass_on_signal();
  void report_progress(const char* phase, unsigned long count);

  void take(Message message);
  [[noreturn]] void refuse(Word word, ProtocolFault fault) const;
  std::optional<Word> carry_out(ParticipantAction action, Message message);
  std::optional<Word> work(ParticipantAction action, const Message& command);
  std::optional<Spoil> begin_phase(const char* phase);

  std::optional<Word> join(const Message& welcome);
  Word insert(const Message& command);
  Word advance(const Message& command);
  Word report(const Message& command);
  Word save();
  Word restore(const Message& command);
  Word finish();
  void require_revision(const Message& command) const;
  Message network_and_state();
  Word reply(MessageType type, Message message);

  void wait_for_release();
  int report_failure(ExitCode code, const std::string& reason);

  Role role_;
  const ParticipantOptions& options_;
  Solver& solver_;
  ParticipantChannel channel_;
  ParticipantState state_ = ParticipantState::greeting;
  Seconds deadline_;
  FractureNetwork network_;
  std::optional<Message> kept_;  ///< a command that came while the solver joined
  std::uint64_t interval_ = 0;
  double work_seconds_ = 0;  ///< wall time between command and reply
};

}  // namespace fissura
