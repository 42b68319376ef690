// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/exchange/message.hpp"

/// The only door to ZeroMQ. Every wait has a deadline; a message is checked (codec.hpp) and its run, epoch and sequence are
/// compared before anybody sees it.
namespace fissura {

using Seconds = std::chrono::duration<double>;

/// Nothing arrived within the time given.
struct Silence {};

/// The connection is gone: the peer ended, or did not answer the transport's heartbeat for `transport_silence`.
struct ConnectionLost {};

/// How long a stopped or vanished peer stays unnoticed by the transport.
inline constexpr Seconds transport_silence{1.5};

/// A participant's end: one DEALER that connects to the coupler and never reconnects.
class ParticipantChannel {
 public:
  /// Throws Error(precondition) if the endpoint is malformed.
  explicit ParticipantChannel(const std::string& endpoint);
  ~ParticipantChannel();

  /// Stamps every further message with the run of WELCOME and refuses others.
  void adopt_run(const RunId& run, std::uint32_t epoch);

  /// Throws ProtocolError if the outgoing queue is full (the lock-step exchange is broken).
  void send(Message message);

  /// Waits at most `patience`. Throws ProtocolError for a damaged, lost, doubled or foreign message. Messages that have not been received
  /// when the connection breaks may be lost with it, so the coupler waits for its participants before it goes.
  std::variant<Message, Silence, ConnectionLost> receive(Seconds patience);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Number the coupler gives a connection; never reused within a run.
using PeerNumber = std::uint64_t;

/// The coupler's end: one ROUTER.
class CouplerChannel {
 public:
  struct Received {
    PeerNumber peer = 0;
    Message message;
  };
  struct PeerLost {
    PeerNumber peer = 0;
  };
  /// What a peer sent could not be accepted; `reason` says why. `greeting` is the body, as far as it can be read, of
  /// what a peer of another major version said.
  struct PeerFault {
    PeerNumber peer = 0;
    std::string reason;
    std::optional<nlohmann::json> greeting = {};
  };
  /// One of the file descriptors of `wait` became readable.
  struct Readable {
    int descriptor = -1;
  };
  using Event = std::variant<Silence, Received, PeerLost, PeerFault, Readable>;

  /// Binds `endpoint` (ipc://PATH or tcp://127.0.0.1:*). Throws Error(role_taken) if it is in use.
  CouplerChannel(const std::string& endpoint, const RunId& run, std::uint32_t epoch);
  ~CouplerChannel();

  /// The address participants connect to, with the port filled in.
  [[nodiscard]] const std::string& endpoint() const;

  /// Throws ProtocolError if the peer is gone or its queue is full.
  void send(PeerNumber peer, Message message);

  /// The next event, waiting at most `patience`; `descriptors` (pidfds, pipes) are watched as well. Messages come before
  /// the loss of the connection they came on.
  Event wait(Seconds patience, const std::vector<int>& descriptors);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fissura
