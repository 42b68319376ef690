// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "common/exchange/curve_keys.hpp"
#include "common/exchange/message.hpp"

/// The only door to ZeroMQ. Every wait has a deadline; a message is checked (codec.hpp) and its run, epoch
/// and sequence are compared before anybody sees it.
namespace fissura {

using Seconds = std::chrono::duration<double>;

/// Nothing arrived within the time given.
struct Silence {};

/// The connection is gone: the peer ended, or did not answer the transport's heartbeat for
/// `transport_silence`.
struct ConnectionLost {};

/// How a connection ended: the peer closed it (or its process ended); the peer sent a frame above the bound
/// or broke the framing of ZMTP, so that it was cut here; or it did not answer the transport's heartbeat.
enum class Loss { closed, broke_framing, fell_silent };

/// How long a stopped or vanished peer stays unnoticed by the transport.
inline constexpr Seconds transport_silence{1.5};

/// A participant's end: one DEALER that connects to the coupler and never reconnects.
class ParticipantChannel {
 public:
  /// Connects, trying anew for at most `patience` while nobody listens there; with `keys`, only to the
  /// coupler they name, by CURVE. Throws Error(precondition) if the endpoint is malformed or nobody came to
  /// listen.
  ParticipantChannel(const std::string& endpoint, const std::optional<ParticipantKeys>& keys,
                     Seconds patience);
  /// Without keys, to a coupler that listens already.
  explicit ParticipantChannel(const std::string& endpoint);
  ~ParticipantChannel();

  /// Stamps every further message with the run of WELCOME and refuses others.
  void adopt_run(const RunId& run, std::uint32_t epoch);

  /// Throws ProtocolError if the outgoing queue is full (the lock-step exchange is broken).
  void send(Message message);

  /// Waits at most `patience`. Throws ProtocolError for a damaged, lost, doubled or foreign message,
  /// Error(security) if the coupler does not accept the keys, or the lack of them. Messages that have not
  /// been received when the connection breaks may be lost with it, so the coupler waits for its participants
  /// before it goes.
  std::variant<Message, Silence, ConnectionLost> receive(Seconds patience);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Number the coupler gives a connection; never reused within a run.
using PeerNumber = std::uint64_t;

/// The frames of one message: envelope, body, arrays.
using FrameViews = std::span<const std::span<const std::byte>>;

/// Sees every message of a coupler's channel as it is on the wire: one to a peer when it is stamped, just
/// before it is handed to the transport; one of a peer when it has come, before anything in it is checked.
class FrameObserver {
 public:
  virtual ~FrameObserver() = default;
  virtual void sent(PeerNumber peer, FrameViews frames) = 0;
  virtual void received(PeerNumber peer, FrameViews frames) = 0;
};

/// Where and to whom the coupler listens.
struct Listening {
  std::string endpoint;                  ///< ipc://PATH, tcp://ADDRESS:PORT, tcp://ADDRESS:*
  std::optional<CouplerKeys> keys = {};  ///< with them, only participants that prove theirs, by CURVE
  std::int64_t largest_frame = std::int64_t{1} << 30;  ///< [bytes]; a larger one ends its connection
  std::size_t most_connections = 64;  ///< at a time; beyond it the oldest of strangers are closed
};

/// The coupler's end: one ROUTER. Strangers never disturb: who does not begin with HELLO is cut off and
/// logged, each kind once a minute.
class CouplerChannel {
 public:
  struct Received {
    PeerNumber peer = 0;
    Message message;
    std::optional<std::string> proven_role;  ///< whose key the peer has; nothing without keys
  };
  struct PeerLost {
    PeerNumber peer = 0;
    Loss how = Loss::closed;
  };
  /// What a peer sent could not be accepted; `reason` says why. `greeting` is the body, as far as it can be
  /// read, of what a peer of another major version said.
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

  /// Binds. With keys, proves first that they work (key_check.hpp). Throws Error(role_taken) naming the port
  /// if the endpoint is in use.
  CouplerChannel(const Listening& listening, const RunId& run, std::uint32_t epoch);
  /// Without keys.
  CouplerChannel(const std::string& endpoint, const RunId& run, std::uint32_t epoch);
  ~CouplerChannel();

  /// The address participants of this machine connect to, with the port filled in.
  [[nodiscard]] const std::string& endpoint() const;

  /// From now on `observer` sees what passes. What it throws comes out of `send` and `wait`. @pre it outlives
  /// the channel
  void observe(FrameObserver& observer);

  /// Logs "a peer was WHAT", at most once a minute for each `kind`.
  void note(const std::string& kind, const std::string& what);

  /// `peer` is no participant: ends its connection and logs "a peer was cut off: it REASON" (sparsely).
  void dismiss(PeerNumber peer, const std::string& reason);

  /// Throws ProtocolError if the peer is gone or its queue is full.
  void send(PeerNumber peer, Message message);

  /// The next event, waiting at most `patience`; `descriptors` (pidfds, pipes) are watched as well. Messages
  /// come before the loss of the connection they came on.
  Event wait(Seconds patience, const std::vector<int>& descriptors);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fissura
