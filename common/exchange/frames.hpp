// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/exchange/codec.hpp"

struct zmq_pollitem_t;

namespace zmq {
class message_t;
class socket_t;
}  // namespace zmq

/// What the sockets of coupler and participants have in common.
namespace fissura {

/// No bound on the size of a frame is below this [bytes].
inline constexpr std::int64_t smallest_frame_bound = std::int64_t{16} << 20;

/// Queues, heartbeat, handshake deadline, no reconnecting. A frame above `largest_frame` bytes ends its
/// connection.
void set_common_options(zmq::socket_t& socket, std::int64_t largest_frame);

enum class More { none, follow };

/// Without waiting. @returns false if the queue is full
bool send_frame(zmq::socket_t& socket, zmq::message_t&& frame, More more);
bool send_frames(zmq::socket_t& socket, EncodedMessage&& encoded);

/// All frames of one message, or none if nothing is waiting.
std::vector<zmq::message_t> receive_frames(zmq::socket_t& socket);

/// Throws what decode throws.
DecodedMessage decode_frames(std::span<const zmq::message_t> frames);

/// The role whose key the sender of `frame` has proven; nothing without keys.
std::optional<std::string> proven_role(const zmq::message_t& frame);

/// Waits at most `patience` (rounded up to milliseconds); returns early where a signal comes.
void poll(std::span<zmq_pollitem_t> items, std::chrono::duration<double> patience);

}  // namespace fissura
