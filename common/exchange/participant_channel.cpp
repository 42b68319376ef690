// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstring>
#include <thread>
#include <zmq.hpp>

#include "common/errors.hpp"
#include "common/exchange/channel.hpp"
#include "common/exchange/frames.hpp"
#include "common/exchange/key_check.hpp"
#include "common/exchange/stamp_check.hpp"

namespace fissura {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::int64_t largest_frame = std::int64_t{1} << 36;
constexpr const char* reports_address = "inproc://connection";
constexpr int watched_events = ZMQ_EVENT_CONNECTED | ZMQ_EVENT_CLOSED | ZMQ_EVENT_DISCONNECTED |
                               ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL | ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL |
                               ZMQ_EVENT_HANDSHAKE_FAILED_AUTH;

/// One attempt to reach the coupler: a DEALER and what the transport reports of it.
class Attempt {
 public:
  Attempt(zmq::context_t& context, const std::string& endpoint, const std::optional<ParticipantKeys>& keys)
      : socket_(context, zmq::socket_type::dealer), reports_(context, zmq::socket_type::pair) {
    set_common_options(socket_, largest_frame);
    socket_.set(zmq::sockopt::ipv6, endpoint.find('[') != std::string::npos);
    if (keys) use_keys(socket_, *keys);
    if (zmq_socket_monitor(socket_.handle(), reports_address, watched_events) != 0)
      throw Error(ExitCode::internal, "cannot watch the connection");
    reports_.set(zmq::sockopt::linger, 0);
    reports_.connect(reports_address);
    try {
      socket_.connect(endpoint);
    } catch (const zmq::error_t& fault) {
      throw Error(ExitCode::precondition, fmt::format("cannot connect to {}: {}", endpoint, fault.what()));
    }
  }
  ~Attempt() { zmq_socket_monitor(socket_.handle(), nullptr, 0); }
  Attempt(const Attempt&) = delete;
  Attempt& operator=(const Attempt&) = delete;

  /// Whether somebody listens there.
  bool is_connected(Seconds patience) {
    zmq::pollitem_t item{reports_.handle(), 0, ZMQ_POLLIN, 0};
    poll({&item, 1}, patience);
    return next_report() == ZMQ_EVENT_CONNECTED;
  }

  /// Number of the next event, 0 if there is none.
  int next_report() {
    const std::vector<zmq::message_t> report = receive_frames(reports_);
    if (report.empty()) return 0;
    std::uint16_t event = 0;
    std::memcpy(&event, report[0].data<char>(), sizeof(event));
    return event;
  }

  zmq::socket_t& socket() { return socket_; }
  zmq::socket_t& reports() { return reports_; }

 private:
  zmq::socket_t socket_, reports_;
};

}  // namespace

class ParticipantChannel::Implementation {
 public:
  Implementation(const std::string& endpoint, const std::optional<ParticipantKeys>& keys, Seconds patience) {
    constexpr Seconds longest_attempt{2.0};
    constexpr std::chrono::milliseconds pause{100};
    const Clock::time_point begin = Clock::now();
    for (;;) {
      attempt_ = std::make_unique<Attempt>(context_, endpoint, keys);
      if (attempt_->is_connected(longest_attempt)) return;
      attempt_->socket().set(zmq::sockopt::linger, 0);
      attempt_.reset();
      if (Clock::now() - begin >= patience)
        throw Error(ExitCode::precondition, fmt::format("no coupler listens on {}", endpoint));
      std::this_thread::sleep_for(pause);
    }
  }

  void adopt_run(const RunId& run, std::uint32_t epoch) {
    run_ = run;
    epoch_ = epoch;
  }

  void send(Message message) {
    if (lost_) return;
    if (!send_frames(attempt_->socket(), encode(std::move(message), {run_, epoch_, sent_}))) {
      // A connection that has just ended takes nothing either.
      hear_reports();
      if (lost_) return;
      throw ProtocolError("the outgoing queue to the coupler is full");
    }
    ++sent_;
  }

  std::variant<Message, Silence, ConnectionLost> receive(Seconds patience) {
    zmq::pollitem_t items[] = {{attempt_->socket().handle(), 0, ZMQ_POLLIN, 0},
                               {attempt_->reports().handle(), 0, ZMQ_POLLIN, 0}};
    poll(items, lost_ ? Seconds(0) : patience);
    const std::vector<zmq::message_t> frames = receive_frames(attempt_->socket());
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
    hear_reports();
    if (lost_) return ConnectionLost{};
    return Silence{};
  }

 private:
  void hear_reports() {
    for (int event = attempt_->next_report(); event != 0; event = attempt_->next_report()) {
      if (event == ZMQ_EVENT_DISCONNECTED) lost_ = true;
      if (event == ZMQ_EVENT_HANDSHAKE_FAILED_AUTH)
        throw Error(ExitCode::security, "the coupler does not accept the key of this participant");
      if (event == ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL || event == ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL)
        throw Error(ExitCode::security,
                    "the handshake with the coupler failed: it is another coupler than coupler.public names, "
                    "or only one of the two was started with --keys, or it has just ended");
    }
  }

  zmq::context_t context_;
  std::unique_ptr<Attempt> attempt_;
  StampCheck check_;
  RunId run_{};
  std::uint32_t epoch_ = 0;
  std::uint64_t sent_ = 0;
  bool lost_ = false;
};

ParticipantChannel::ParticipantChannel(const std::string& endpoint,
                                       const std::optional<ParticipantKeys>& keys, Seconds patience)
    : implementation_(std::make_unique<Implementation>(endpoint, keys, patience)) {}
ParticipantChannel::ParticipantChannel(const std::string& endpoint)
    : ParticipantChannel(endpoint, std::nullopt, Seconds(0)) {}
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

}  // namespace fissura
