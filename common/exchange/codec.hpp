// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "common/exchange/envelope.hpp"
#include "common/exchange/message.hpp"

namespace fissura {

/// A message as frames, ready for a socket. Arrays are moved, not copied.
struct EncodedMessage {
  EnvelopeBytes envelope{};
  std::string body;
  std::vector<std::vector<std::byte>> arrays;
};

/// Its frames in their order, as long as it stays where it is.
std::vector<std::span<const std::byte>> frames_of(const EncodedMessage& encoded);

/// Identity of a sender within a run: stamped on every message, checked on every receipt.
struct Stamp {
  RunId run{};
  std::uint32_t epoch = 0;
  std::uint64_t sequence = 0;
};

/// Pure function; the inverse of decode.
EncodedMessage encode(Message message, const Stamp& stamp);

/// A received message with the stamp it carries.
struct DecodedMessage {
  Message message;
  Stamp stamp;
};

/// Checks size, magic, version, checksum, the body's JSON, and every array against its declaration. Throws ProtocolError
/// naming the fault. `frames` are envelope, body, arrays.
DecodedMessage decode(std::span<const std::span<const std::byte>> frames);

}  // namespace fissura
