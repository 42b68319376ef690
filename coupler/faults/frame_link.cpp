// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/faults/frame_link.hpp"

#include <fmt/format.h>

#include <cstring>
#include <zmq.hpp>

#include "common/errors.hpp"
#include "common/exchange/channel.hpp"
#include "common/exchange/debugger.hpp"

namespace fissura::coupler {

namespace {

constexpr int heartbeat_interval_ms = 400;
constexpr int linger_ms = 1000;

}  // namespace

class FrameLink::Implementation {
 public:
  enum class End { connects, listens };

  Implementation(const std::string& endpoint, End end)
      : socket_(context_, zmq::socket_type::dealer), reports_(context_, zmq::socket_type::pair) {
    const char* address = "inproc://connections";
    if (zmq_socket_monitor(socket_.handle(), address, ZMQ_EVENT_DISCONNECTED) != 0)
      throw Error(ExitCode::internal, "cannot watch the connections");
    reports_.set(zmq::sockopt::linger, 0);
    reports_.connect(address);
    const int silence_ms = static_cast<int>(transport_silence.count() * 1000);
    socket_.set(zmq::sockopt::linger, linger_ms);
    if (!may_be_held()) {
      socket_.set(zmq::sockopt::heartbeat_ivl, heartbeat_interval_ms);
      socket_.set(zmq::sockopt::heartbeat_timeout, silence_ms - heartbeat_interval_ms);
      socket_.set(zmq::sockopt::heartbeat_ttl, 2 * silence_ms);
    }
    socket_.set(zmq::sockopt::reconnect_ivl, -1);
    try {
      if (end == End::connects)
        socket_.connect(endpoint);
      else
        socket_.bind(endpoint);
    } catch (const zmq::error_t& fault) {
      throw Error(ExitCode::precondition, fmt::format("cannot use {}: {}", endpoint, fault.what()));
    }
  }

  ~Implementation() {
    if (!closed_) zmq_socket_monitor(socket_.handle(), nullptr, 0);
  }

  bool send(const Frames& frames) {
    if (closed_) return false;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const auto flags = i + 1 < frames.size() ? zmq::send_flags::sndmore | zmq::send_flags::dontwait
                                               : zmq::send_flags::dontwait;
      if (!socket_.send(zmq::buffer(frames[i].data(), frames[i].size()), flags)) return false;
    }
    return true;
  }

  std::optional<Frames> receive() {
    if (closed_) return std::nullopt;
    Frames frames;
    bool more = true;
    while (more) {
      zmq::message_t frame;
      if (!socket_.recv(frame, zmq::recv_flags::dontwait)) return std::nullopt;
      const auto* begin = frame.data<std::byte>();
      frames.emplace_back(begin, begin + frame.size());
      more = frame.more();
    }
    return frames;
  }

  bool lost() {
    if (closed_) return true;
    zmq::message_t report;
    while (reports_.recv(report, zmq::recv_flags::dontwait)) {
      const bool more = report.more();
      std::uint16_t event = 0;
      std::memcpy(&event, report.data(), sizeof(event));
      if (event == ZMQ_EVENT_DISCONNECTED) lost_ = true;
      while (more && report.more() && reports_.recv(report, zmq::recv_flags::dontwait)) {
      }
    }
    return lost_;
  }

  void close(int linger) {
    if (closed_) return;
    socket_.set(zmq::sockopt::linger, linger);
    zmq_socket_monitor(socket_.handle(), nullptr, 0);
    closed_ = true;
    socket_.close();
  }

  std::vector<zmq::pollitem_t> poll_items() {
    if (closed_) return {};
    std::vector<zmq::pollitem_t> items{{socket_.handle(), 0, ZMQ_POLLIN, 0}};
    if (!lost_) items.push_back({reports_.handle(), 0, ZMQ_POLLIN, 0});
    return items;
  }

 private:
  zmq::context_t context_;
  zmq::socket_t socket_;
  zmq::socket_t reports_;
  bool lost_ = false, closed_ = false;
};

FrameLink::FrameLink(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
FrameLink::~FrameLink() = default;
FrameLink::FrameLink(FrameLink&&) noexcept = default;

FrameLink FrameLink::connected(const std::string& endpoint) {
  return FrameLink(std::make_unique<Implementation>(endpoint, Implementation::End::connects));
}
FrameLink FrameLink::listening(const std::string& endpoint) {
  return FrameLink(std::make_unique<Implementation>(endpoint, Implementation::End::listens));
}

bool FrameLink::send(const Frames& frames) {
  return implementation_->send(frames);
}
std::optional<Frames> FrameLink::receive() {
  return implementation_->receive();
}
bool FrameLink::lost() {
  return implementation_->lost();
}
void FrameLink::close() {
  implementation_->close(linger_ms);
}
void FrameLink::cut() {
  implementation_->close(0);
}

void wait_for_any(FrameLink& first, FrameLink& second, int descriptor, std::chrono::milliseconds longest) {
  std::vector<zmq::pollitem_t> items{{nullptr, descriptor, ZMQ_POLLIN, 0}};
  for (FrameLink* link : {&first, &second})
    for (const zmq::pollitem_t& item : link->implementation_->poll_items()) items.push_back(item);
  zmq::poll(items, longest);
}

void wait_for(FrameLink& link, int descriptor, std::chrono::milliseconds longest) {
  std::vector<zmq::pollitem_t> items = link.implementation_->poll_items();
  if (descriptor >= 0) items.push_back({nullptr, descriptor, ZMQ_POLLIN, 0});
  zmq::poll(items, longest);
}

}  // namespace fissura::coupler
