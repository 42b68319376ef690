// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <deque>
#include <map>
#include <zmq.hpp>

#include "common/errors.hpp"
#include "common/exchange/channel.hpp"
#include "common/exchange/connection_guard.hpp"
#include "common/exchange/frames.hpp"
#include "common/exchange/key_check.hpp"
#include "common/exchange/stamp_check.hpp"

namespace fissura {

namespace {

/// What can be read of a message that says things in another version.
nlohmann::json body_of(std::span<const zmq::message_t> frames) {
  if (frames.size() < 2) return nlohmann::json::object();
  nlohmann::json body = nlohmann::json::parse(frames[1].to_string_view(), nullptr, false);
  return body.is_object() ? body : nlohmann::json::object();
}

/// "tcp://0.0.0.0:5555" is every address of this machine; one of them is loopback.
std::string reachable_here(std::string endpoint) {
  for (const auto& [any, loopback] :
       {std::pair{"tcp://0.0.0.0:", "tcp://127.0.0.1:"}, {"tcp://[::]:", "tcp://[::1]:"}})
    if (endpoint.starts_with(any)) endpoint.replace(0, std::string_view(any).size(), loopback);
  return endpoint;
}

std::vector<std::span<const std::byte>> views_of(std::span<const zmq::message_t> frames) {
  std::vector<std::span<const std::byte>> views;
  for (const zmq::message_t& frame : frames) views.emplace_back(frame.data<std::byte>(), frame.size());
  return views;
}

std::string why_not_bound(const std::string& endpoint, const zmq::error_t& fault) {
  if (fault.num() == EADDRINUSE)
    return fmt::format(
        "port {} of {} is in use by another process: wait for it, choose another port in exchange.endpoint, "
        "or `*` for any",
        endpoint.substr(endpoint.rfind(':') + 1), endpoint.substr(0, endpoint.rfind(':')));
  return fmt::format("cannot listen on {}: {}", endpoint, fault.what());
}

}  // namespace

class CouplerChannel::Implementation {
 public:
  Implementation(const Listening& listening, const RunId& run, std::uint32_t epoch)
      : key_check_(listening.keys ? std::make_unique<KeyCheck>(context_, *listening.keys) : nullptr),
        socket_(context_, zmq::socket_type::router),
        guard_(context_, socket_, listening.most_connections),
        run_(run),
        epoch_(epoch) {
    set_common_options(socket_, listening.largest_frame);
    socket_.set(zmq::sockopt::ipv6, listening.endpoint.find('[') != std::string::npos);
    // A connection for which there is no room in the queue tries again only after a second.
    socket_.set(zmq::sockopt::backlog, 1024);
    socket_.set(zmq::sockopt::router_mandatory, true);
    socket_.set(zmq::sockopt::router_handover, false);
    if (key_check_) {
      key_check_->prove();
      key_check_->guard(socket_);
    }
    try {
      socket_.bind(listening.endpoint);
    } catch (const zmq::error_t& fault) {
      throw Error(fault.num() == EADDRINUSE ? ExitCode::role_taken : ExitCode::precondition,
                  why_not_bound(listening.endpoint, fault));
    }
    endpoint_ = reachable_here(socket_.get(zmq::sockopt::last_endpoint));
  }

  [[nodiscard]] const std::string& endpoint() const { return endpoint_; }

  void send(PeerNumber number, Message message) {
    const MessageType type = message.type;
    const std::string label = name(type);
    const auto found = peers_.find(number);
    if (found == peers_.end()) throw ProtocolError(label + " could not be sent: the peer is gone");
    Peer& peer = found->second;
    if (message.type == MessageType::welcome && peer.connection) guard_.keep(*peer.connection);
    try {
      EncodedMessage encoded = encode(std::move(message), {run_, epoch_, peer.sent});
      if (observer_ != nullptr) observer_->sent(number, frames_of(encoded));
      zmq::message_t identity(peer.identity.data(), peer.identity.size());
      if (!send_frame(socket_, std::move(identity), More::follow) ||
          !send_frames(socket_, std::move(encoded)))
        throw ProtocolError(fmt::format("{} could not be sent: the outgoing queue is full", label));
      ++peer.sent;
      if (type == MessageType::welcome || type == MessageType::reject)
        peer.rejected = peer.sent == 1 && type == MessageType::reject;
    } catch (const zmq::error_t& fault) {
      throw ProtocolError(fmt::format("{} could not be sent: {}", label, fault.what()));
    }
  }

  Event wait(Seconds patience, const std::vector<int>& descriptors) {
    if (!losses_.empty()) patience = Seconds(0);
    std::vector<zmq::pollitem_t> items{{socket_.handle(), 0, ZMQ_POLLIN, 0},
                                       {nullptr, guard_.descriptor(), ZMQ_POLLIN, 0}};
    for (const int descriptor : descriptors) items.push_back({nullptr, descriptor, ZMQ_POLLIN, 0});
    poll(items, patience);

    // Losses are fetched before the message is: one that came before a loss is then seen before it.
    take_losses();
    if (std::optional<Event> event = next_message()) return std::move(*event);
    for (std::size_t i = 2; i < items.size(); ++i)
      if (items[i].revents != 0) return Readable{items[i].fd};
    if (losses_.empty()) return Silence{};
    const PeerLost loss = losses_.front();
    losses_.pop_front();
    peers_.erase(loss.peer);
    return loss;
  }

  void observe(FrameObserver& observer) { observer_ = &observer; }

  void note(const std::string& kind, const std::string& what) { guard_.note(kind, what); }

  void dismiss(PeerNumber number, const std::string& reason) {
    note("dismissed", "cut off: it " + reason);
    const auto found = peers_.find(number);
    if (found == peers_.end()) return;
    if (found->second.connection) guard_.cut(*found->second.connection);
  }

 private:
  struct Peer {
    std::string identity;
    std::optional<ConnectionGuard::Number> connection;
    std::uint64_t sent = 0;
    bool rejected = false;
    StampCheck check;
  };

  void take_losses() {
    for (const ConnectionGuard::Ended& ended : guard_.ended())
      for (const auto& [number, peer] : peers_)
        if (peer.connection == ended.connection) losses_.push_back({number, ended.how});
  }

  std::optional<Event> next_message() {
    for (std::vector<zmq::message_t> frames = receive_frames(socket_); !frames.empty();
         frames = receive_frames(socket_)) {
      const std::optional<PeerNumber> known = known_peer(frames[0]);
      if (known && peers_.at(*known).rejected) {
        dismiss(*known, "went on after it had been refused");
        continue;
      }
      if (known) return event_of(*known, frames);
      if (std::optional<Event> event = first_event(frames)) return event;
    }
    return std::nullopt;
  }

  std::optional<PeerNumber> known_peer(const zmq::message_t& identity) const {
    for (const auto& [number, peer] : peers_)
      if (peer.identity == identity.to_string_view()) return number;
    return std::nullopt;
  }

  /// Who begins with something else than HELLO is not heard; who cannot be understood is to be told.
  std::optional<Event> first_event(const std::vector<zmq::message_t>& frames) {
    const std::optional<ConnectionGuard::Number> connection =
        guard_.connection_of(zmq_msg_get(frames.back().handle(), ZMQ_SRCFD));
    const PeerNumber number = next_peer_++;
    peers_[number] = {frames[0].to_string(), connection, 0, false, {}};
    Event event = event_of(number, frames);
    const auto* message = std::get_if<Received>(&event);
    if (message == nullptr || message->message.type == MessageType::hello) {
      if (!connection) losses_.push_back({number, Loss::closed});
      return event;
    }
    guard_.note("stranger", "cut off: it did not begin with HELLO");
    if (connection) guard_.cut(*connection);
    peers_.erase(number);
    return std::nullopt;
  }

  Event event_of(PeerNumber number, const std::vector<zmq::message_t>& frames) {
    const std::span content = std::span(frames).subspan(1);
    if (observer_ != nullptr) observer_->received(number, views_of(content));
    try {
      return received(number, decode_frames(content), frames.back());
    } catch (const OtherVersion& fault) {
      return PeerFault{number, fault.what(), body_of(content)};
    } catch (const Error& fault) {
      return PeerFault{number, fault.what()};
    }
  }

  Event received(PeerNumber number, DecodedMessage decoded, const zmq::message_t& frame) {
    const bool hello = decoded.message.type == MessageType::hello;
    peers_.at(number).check.check(decoded.stamp, decoded.message, hello ? decoded.stamp.run : run_,
                                  hello ? decoded.stamp.epoch : epoch_);
    return Received{number, std::move(decoded.message), proven_role(frame)};
  }

  zmq::context_t context_;
  std::unique_ptr<KeyCheck> key_check_;
  zmq::socket_t socket_;
  ConnectionGuard guard_;
  RunId run_;
  std::uint32_t epoch_;
  std::string endpoint_;
  std::map<PeerNumber, Peer> peers_;
  PeerNumber next_peer_ = 1;
  std::deque<PeerLost> losses_;
  FrameObserver* observer_ = nullptr;
};

CouplerChannel::CouplerChannel(const Listening& listening, const RunId& run, std::uint32_t epoch)
    : implementation_(std::make_unique<Implementation>(listening, run, epoch)) {}
CouplerChannel::CouplerChannel(const std::string& endpoint, const RunId& run, std::uint32_t epoch)
    : CouplerChannel(Listening{.endpoint = endpoint}, run, epoch) {}
CouplerChannel::~CouplerChannel() = default;
const std::string& CouplerChannel::endpoint() const {
  return implementation_->endpoint();
}
void CouplerChannel::observe(FrameObserver& observer) {
  implementation_->observe(observer);
}
void CouplerChannel::note(const std::string& kind, const std::string& what) {
  implementation_->note(kind, what);
}
void CouplerChannel::dismiss(PeerNumber peer, const std::string& reason) {
  implementation_->dismiss(peer, reason);
}
void CouplerChannel::send(PeerNumber peer, Message message) {
  implementation_->send(peer, std::move(message));
}
CouplerChannel::Event CouplerChannel::wait(Seconds patience, const std::vector<int>& descriptors) {
  return implementation_->wait(patience, descriptors);
}

}  // namespace fissura
