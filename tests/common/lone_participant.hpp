// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <thread>

#include "common/exchange/channel.hpp"
#include "common/exchange/participant.hpp"

namespace fissura::test {

/// A participant on a thread of this process; the test is its coupler. It ends with the connection if the
/// test has not ended it.
class LoneParticipant {
 public:
  /// Returns when the participant has said HELLO.
  LoneParticipant(Role role, Solver& solver, std::uint32_t epoch = 0);
  ~LoneParticipant();

  [[nodiscard]] const Message& hello() const { return hello_; }
  void send(Message command);
  /// The next message that is not PROGRESS. Fails the test if none comes.
  Message receive();
  Message request(Message command);
  /// WELCOME with an empty case.
  void welcome(bool resumes);
  /// Exit code of the participant, which must be at its end.
  int end();

 private:
  static std::filesystem::path new_folder();

  std::filesystem::path folder_ = new_folder();
  CouplerChannel coupler_;
  PeerNumber peer_ = 0;
  Message hello_;
  int code_ = -1;
  std::thread participant_;
};

}  // namespace fissura::test
