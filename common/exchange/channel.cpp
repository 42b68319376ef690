// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/channel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <deque>
#include <map>
#include <span>
#include <zmq.hpp>

#include "common/errors.hpp"
#include "common/exchange/codec.hpp"

namespace fissura {

namespace {

constexpr int queue_length = 64;
constexpr std::int64_t largest_frame = std::int64_t{1} << 30;
constexpr int heartbeat_interval_ms = 400;
constexpr int linger_ms = 1000;

void set_common_options(zmq::socket_t& socket) {
  const int silence_ms = static_cast<int>(transport_silence.count() * 1000);
  socket.set(zmq::sockopt::linger, linger_ms);
  socket.set(zmq::sockopt::sndhwm, queue_length);
  socket.set(zmq::sockopt::rcvhwm, queue_length);
  socket.set(zmq::sockopt::maxmsgsize, largest_frame);
  socket.set(zmq::sockopt::handshake_ivl, 2000);
  socket.set(zmq::sockopt::heartbeat_ivl, heartbeat_interval_ms);
  socket.set(zmq::sockopt::heartbeat_timeout, silence_ms - heartbeat_interval_ms);
  socket.set(zmq::sockopt::heartbeat_ttl, 2 * silence_ms);
  socket.set(zmq::sockopt::reconnect_ivl, -1);
}

std::chrono::milliseconds milliseconds(Seconds patience) {
  return std::chrono::milliseconds(static_cast<long>(std::ceil(std::max(0.0, patience.count()) * 1000)));
}

void release_vector(void*, void* hint) {
  delete static_cast<std::vector<std::byte>*>(hint);
}

zmq::message_t frame_owning(std::vector<std::byte>&& bytes) {
  auto* owner = new std::vector<std::byte>(std::move(bytes));
  return zmq::message_t(owner->data(), owner->size(), release_vector, owner);
}

/// Calls `transfer` again if a signal that the process handles (a request for its stack) came in between.
template <typename Transfer>
auto uninterrupted(const Transfer& transfer) {
  for (;;) {
    try {
      return transfer();
    } catch (const zmq::error_t& fault) {
      if (fault.num() != EINTR) throw;
    }
  }
}

bool send_frames(zmq::socket_t& socket, EncodedMessage&& encoded) {
  const auto more = zmq::send_flags::sndmore | zmq::send_flags::dontwait;
  if (!uninterrupted([&] { return socket.send(zmq::buffer(encoded.envelope), more); })) return false;
  const bool has_arrays = !encoded.arrays.empty();
  if (!uninterrupted([&] {
        return socket.send(zmq::buffer(encoded.body), has_arrays ? more : zmq::send_flags::dontwait);
      }))
    return false;
  for (std::size_t i = 0; i < encoded.arrays.size(); ++i) {
    const bool last = i + 1 == encoded.arrays.size();
    zmq::message_t frame = frame_owning(std::move(encoded.arrays[i]));
    if (!uninterrupted([&] { return socket.send(frame, last ? zmq::send_flags::dontwait : more); }))
      return false;
  }
  return true;
}

/// Returns early where a signal comes.
void poll(std::span<zmq::pollitem_t> items, Seconds patience) {
  try {
    zmq::poll(items.data(), items.size(), milliseconds(patience));
  } catch (const zmq::error_t& fault) {
    if (fault.num() != EINTR) throw;
    for (zmq::pollitem_t& item : items) item.revents = 0;
  }
}

bool receive_frame(zmq::socket_t& socket, zmq::message_t& frame) {
  return uninterrupted([&] { return socket.recv(frame, zmq::recv_flags::dontwait).has_value(); });
}

/// All frames of one message, or none if nothing is waiting.
std::vector<zmq::message_t> receive_frames(zmq::socket_t& socket) {
  std::vector<zmq::message_t> frames;
  do {
    zmq::message_t frame;
    if (!receive_frame(socket, frame)) break;
    frames.push_back(std::move(frame));
  } while (frames.back().more());
  return frames;
}

DecodedMessage decode_frames(std::span<const zmq::message_t> frames) {
  std::vector<std::span<const std::byte>> views;
  for (const zmq::message_t& frame : frames)
    views.emplace_back(static_cast<const std::byte*>(frame.data()), frame.size());
  return decode(views);
}

/// What can be read of a message that says things in another version.
nlohmann::json body_of(std::span<const zmq::message_t> frames) {
  if (frames.size() < 2) return nlohmann::json::object();
  nlohmann::json body = nlohmann::json::parse(frames[1].to_string_view(), nullptr, false);
  return body.is_object() ? body : nlohmann::json::object();
}

/// Reports of the transport about its connections.
class ConnectionMonitor {
 public:
  ConnectionMonitor(zmq::context_t& context, zmq::socket_t& watched, const std::string& address)
      : watched_(watched), reports_(context, zmq::socket_type::pair) {
    const int events = ZMQ_EVENT_DISCONNECTED | ZMQ_EVENT_CLOSED;
    if (zmq_socket_monitor(watched.handle(), address.c_str(), events) != 0)
      throw Error(ExitCode::internal, "cannot watch the connections");
    reports_.set(zmq::sockopt::linger, 0);
    reports_.connect(address);
  }
  ~ConnectionMonitor() { zmq_socket_monitor(watched_.handle(), nullptr, 0); }
  ConnectionMonitor(const ConnectionMonitor&) = delete;
  ConnectionMonitor& operator=(const ConnectionMonitor&) = delete;

  zmq::socket_t& socket() { return reports_; }

  /// File descriptor of a connection that was lost, if one is reported.
  std::optional<int> lost_connection() {
    for (;;) {
      const std::vector<zmq::message_t> frames = receive_frames(reports_);
      if (frames.empty()) return std::nullopt;
      std::uint16_t event = 0;
      std::uint32_t descriptor = 0;
      std::memcpy(&event, frames[0].data<char>(), sizeof(event));
      std::memcpy(&descriptor, frames[0].data<char>() + sizeof(event), sizeof(descriptor));
      if (event == ZMQ_EVENT_DISCONNECTED) return static_cast<int>(descriptor);
    }
  }

 private:
  zmq::socket_t& watched_;
  zmq::socket_t reports_;
};

/// Run, epoch and gap-free sequence of one direction.
class StampCheck {
 public:
  void check(const Stamp& stamp, const Message& message, const RunId& run, std::uint32_t epoch) {
    const std::string label = fmt::format("{} of interval {}", name(message.type), message.interval);
    if (stamp.run != run) throw ProtocolError(label + " belongs to another run");
    if (stamp.epoch != epoch)
      throw ProtocolError(fmt::format("{} belongs to epoch {}, this is epoch {}", label, stamp.epoch, epoch));
    if (stamp.sequence > expected_)
      throw ProtocolError(
          fmt::format("{} message(s) before {} were lost", stamp.sequence - expected_, label));
    if (stamp.sequence < expected_) throw ProtocolError(label + " came twice");
    ++expected_;
  }

 private:
  std::uint64_t expected_ = 0;
};

}  // namespace

class ParticipantChannel::Implementation {
 public:
  explicit Implementation(const std::string& endpoint)
      : socket_(context_, zmq::socket_type::dealer), monitor_(context_, socket_, "inproc://connections") {
    set_common_options(socket_);
    try {
      socket_.connect(endpoint);
    } catch (const zmq::error_t& fault) {
      throw Error(ExitCode::precondition, fmt::format("cannot connect to {}: {}", endpoint, fault.what()));
    }
  }

  void adopt_run(const RunId& run, std::uint32_t epoch) {
    run_ = run;
    epoch_ = epoch;
  }

  void send(Message message) {
    if (lost_) return;
    if (!send_frames(socket_, encode(std::move(message), {run_, epoch_, sent_})))
      throw ProtocolError("the outgoing queue to the coupler is full");
    ++sent_;
  }

  std::variant<Message, Silence, ConnectionLost> receive(Seconds patience) {
    zmq::pollitem_t items[] = {{socket_.handle(), 0, ZMQ_POLLIN, 0},
                               {monitor_.socket().handle(), 0, ZMQ_POLLIN, 0}};
    poll(items, lost_ ? Seconds(0) : patience);
    const std::vector<zmq::message_t> frames = receive_frames(socket_);
    if (!frames.empty()) {
      DecodedMessage decoded = decode_frames(frames);
      // WELCOME and REJECT are the first to carry the run; the participant cannot know it before.
      const bool handshake =
          decoded.message.type == MessageType::welcome || decoded.message.type == MessageType::reject;
      check_.check(decoded.stamp, decoded.message, handshake ? decoded.stamp.run : run_,
                   handshake ? decoded.stamp.epoch : epoch_);
      if (handshake) adopt_run(decoded.stamp.run, decoded.stamp.epoch);
      return std::move(decoded.message);
    }
    if (monitor_.lost_connection()) lost_ = true;
    if (lost_) return ConnectionLost{};
    return Silence{};
  }

 private:
  zmq::context_t context_;
  zmq::socket_t socket_;
  ConnectionMonitor monitor_;
  StampCheck check_;
  RunId run_{};
  std::uint32_t epoch_ = 0;
  std::uint64_t sent_ = 0;
  bool lost_ = false;
};

ParticipantChannel::ParticipantChannel(const std::string& endpoint)
    : implementation_(std::make_unique<Implementation>(endpoint)) {}
ParticipantChannel::~ParticipantChannel() = default;
void ParticipantChannel::adopt_run(const RunId& run, std::uint32_t epoch) {
  implementation_->adopt_run(run, epoch);
}
void ParticipantChannel::send(Message message) {
  implementation_->send(std::move(message));
}
std::variant<Message, Silence, ConnectionLost> ParticipantChannel::receive(Seconds patience) {
  return implementation_->receive(patience);
}

class CouplerChannel::Implementation {
 public:
  Implementation(const std::string& endpoint, const RunId& run, std::uint32_t epoch)
      : socket_(context_, zmq::socket_type::router),
        monitor_(context_, socket_, "inproc://connections"),
        run_(run),
        epoch_(epoch) {
    set_common_options(socket_);
    socket_.set(zmq::sockopt::router_mandatory, true);
    socket_.set(zmq::sockopt::router_handover, false);
    try {
      socket_.bind(endpoint);
    } catch (const zmq::error_t& fault) {
      const ExitCode code = fault.num() == EADDRINUSE ? ExitCode::role_taken : ExitCode::precondition;
      throw Error(code, fmt::format("cannot listen on {}: {}", endpoint, fault.what()));
    }
    endpoint_ = socket_.get(zmq::sockopt::last_endpoint);
  }

  [[nodiscard]] const std::string& endpoint() const { return endpoint_; }

  void send(PeerNumber number, Message message) {
    Peer& peer = peers_.at(number);
    const std::string label = name(message.type);
    try {
      const auto flags = zmq::send_flags::sndmore | zmq::send_flags::dontwait;
      if (!uninterrupted([&] { return socket_.send(zmq::buffer(peer.identity), flags); }) ||
          !send_frames(socket_, encode(std::move(message), {run_, epoch_, peer.sent})))
        throw ProtocolError(fmt::format("{} could not be sent: the outgoing queue is full", label));
      ++peer.sent;
    } catch (const zmq::error_t& fault) {
      throw ProtocolError(fmt::format("{} could not be sent: {}", label, fault.what()));
    }
  }

  Event wait(Seconds patience, const std::vector<int>& descriptors) {
    if (!losses_.empty()) patience = Seconds(0);
    std::vector<zmq::pollitem_t> items{{socket_.handle(), 0, ZMQ_POLLIN, 0},
                                       {monitor_.socket().handle(), 0, ZMQ_POLLIN, 0}};
    for (const int descriptor : descriptors) items.push_back({nullptr, descriptor, ZMQ_POLLIN, 0});
    poll(items, patience);

    if (std::optional<Event> event = next_message()) return std::move(*event);
    while (const std::optional<int> descriptor = monitor_.lost_connection())
      for (const auto& [number, peer] : peers_)
        if (peer.descriptor == *descriptor) losses_.push_back(number);
    for (std::size_t i = 2; i < items.size(); ++i)
      if (items[i].revents != 0) return Readable{items[i].fd};
    if (!losses_.empty()) {
      const PeerNumber number = losses_.front();
      losses_.pop_front();
      return PeerLost{number};
    }
    return Silence{};
  }

 private:
  struct Peer {
    std::string identity;
    int descriptor = -1;
    std::uint64_t sent = 0;
    StampCheck check;
  };

  std::optional<Event> next_message() {
    std::vector<zmq::message_t> frames = receive_frames(socket_);
    if (frames.empty()) return std::nullopt;
    if (frames.size() < 2) return std::nullopt;
    const PeerNumber number = number_of(frames[0], frames[1]);
    Peer& peer = peers_.at(number);
    try {
      DecodedMessage decoded = decode_frames(std::span(frames).subspan(1));
      const bool hello = decoded.message.type == MessageType::hello;
      peer.check.check(decoded.stamp, decoded.message, hello ? decoded.stamp.run : run_,
                       hello ? decoded.stamp.epoch : epoch_);
      return Received{number, std::move(decoded.message)};
    } catch (const OtherVersion& fault) {
      return PeerFault{number, fault.what(), body_of(std::span(frames).subspan(1))};
    } catch (const Error& fault) {
      return PeerFault{number, fault.what()};
    }
  }

  PeerNumber number_of(const zmq::message_t& identity_frame, zmq::message_t& content) {
    const std::string identity = identity_frame.to_string();
    for (auto& [number, peer] : peers_)
      if (peer.identity == identity) return number;
    const PeerNumber number = next_peer_++;
    peers_[number] = {identity, content.get(ZMQ_SRCFD), 0, {}};
    return number;
  }

  zmq::context_t context_;
  zmq::socket_t socket_;
  ConnectionMonitor monitor_;
  RunId run_;
  std::uint32_t epoch_;
  std::string endpoint_;
  std::map<PeerNumber, Peer> peers_;
  PeerNumber next_peer_ = 1;
  std::deque<PeerNumber> losses_;
};

CouplerChannel::CouplerChannel(const std::string& endpoint, const RunId& run, std::uint32_t epoch)
    : implementation_(std::make_unique<Implementation>(endpoint, run, epoch)) {}
CouplerChannel::~CouplerChannel() = default;
const std::string& CouplerChannel::endpoint() const {
  return implementation_->endpoint();
}
void CouplerChannel::send(PeerNumber peer, Message message) {
  implementation_->send(peer, std::move(message));
}
CouplerChannel::Event CouplerChannel::wait(Seconds patience, const std::vector<int>& descriptors) {
  return implementation_->wait(patience, descriptors);
}

}  // namespace fissura
