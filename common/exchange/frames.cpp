// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/frames.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <zmq.hpp>

#include "common/exchange/channel.hpp"
#include "common/exchange/debugger.hpp"

namespace fissura {

namespace {

constexpr int queue_length = 64;
constexpr int heartbeat_interval_ms = 400;
constexpr int linger_ms = 1000;
constexpr int handshake_ms = 2000;

void release_vector(void*, void* hint) {
  delete static_cast<std::vector<std::byte>*>(hint);
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

zmq::message_t frame_owning(std::vector<std::byte>&& bytes) {
  auto* owner = new std::vector<std::byte>(std::move(bytes));
  return zmq::message_t(owner->data(), owner->size(), release_vector, owner);
}

}  // namespace

void set_common_options(zmq::socket_t& socket, std::int64_t largest_frame) {
  const int silence_ms = static_cast<int>(transport_silence.count() * 1000);
  socket.set(zmq::sockopt::linger, linger_ms);
  socket.set(zmq::sockopt::sndhwm, queue_length);
  socket.set(zmq::sockopt::rcvhwm, queue_length);
  socket.set(zmq::sockopt::maxmsgsize, largest_frame);
  socket.set(zmq::sockopt::handshake_ivl, handshake_ms);
  socket.set(zmq::sockopt::reconnect_ivl, -1);
  if (may_be_held()) return;
  socket.set(zmq::sockopt::heartbeat_ivl, heartbeat_interval_ms);
  socket.set(zmq::sockopt::heartbeat_timeout, silence_ms - heartbeat_interval_ms);
  socket.set(zmq::sockopt::heartbeat_ttl, 2 * silence_ms);
}

bool send_frame(zmq::socket_t& socket, zmq::message_t&& frame, More more) {
  const auto flags =
      more == More::follow ? zmq::send_flags::sndmore | zmq::send_flags::dontwait : zmq::send_flags::dontwait;
  return uninterrupted([&] { return socket.send(frame, flags).has_value(); });
}

bool send_frames(zmq::socket_t& socket, EncodedMessage&& encoded) {
  const auto& envelope = encoded.envelope;
  const std::string& body = encoded.body;
  if (!send_frame(socket, zmq::message_t(envelope.data(), envelope.size()), More::follow)) return false;
  if (!send_frame(socket, zmq::message_t(body.data(), body.size()),
                  encoded.arrays.empty() ? More::none : More::follow))
    return false;
  for (std::size_t i = 0; i < encoded.arrays.size(); ++i) {
    const More more = i + 1 == encoded.arrays.size() ? More::none : More::follow;
    if (!send_frame(socket, frame_owning(std::move(encoded.arrays[i])), more)) return false;
  }
  return true;
}

std::vector<zmq::message_t> receive_frames(zmq::socket_t& socket) {
  std::vector<zmq::message_t> frames;
  do {
    zmq::message_t frame;
    if (!uninterrupted([&] { return socket.recv(frame, zmq::recv_flags::dontwait).has_value(); })) break;
    frames.push_back(std::move(frame));
  } while (frames.back().more());
  return frames;
}

void poll(std::span<zmq_pollitem_t> items, std::chrono::duration<double> patience) {
  const double wait = std::ceil(std::max(0.0, patience.count()) * 1000);
  try {
    zmq::poll(items.data(), items.size(), std::chrono::milliseconds(static_cast<long>(wait)));
  } catch (const zmq::error_t& fault) {
    if (fault.num() != EINTR) throw;
    for (zmq_pollitem_t& item : items) item.revents = 0;
  }
}

DecodedMessage decode_frames(std::span<const zmq::message_t> frames) {
  std::vector<std::span<const std::byte>> views;
  for (const zmq::message_t& frame : frames)
    views.emplace_back(static_cast<const std::byte*>(frame.data()), frame.size());
  return decode(views);
}

std::optional<std::string> proven_role(const zmq::message_t& frame) {
  const char* role = zmq_msg_gets(frame.handle(), "User-Id");
  return role == nullptr ? std::nullopt : std::optional<std::string>(role);
}

}  // namespace fissura
