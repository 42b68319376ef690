// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "common/errors.hpp"
#include "common/exchange/message.hpp"

namespace fissura {

inline constexpr std::uint8_t protocol_major = 1;
inline constexpr std::uint8_t protocol_minor = 1;
inline constexpr std::size_t envelope_size = 64;

/// Frame 0 of every message, docs/protocol.md section 2.
struct Envelope {
  std::uint8_t major = protocol_major, minor = protocol_minor;
  MessageType type = MessageType::fail;
  RunId run{};
  std::uint32_t epoch = 0;
  std::uint32_t array_count = 0;
  std::uint64_t sequence = 0;
  std::uint64_t interval = 0;
  std::uint64_t revision = 0;
  std::uint32_t body_length = 0;
  std::uint32_t checksum = 0;  ///< CRC-32 of the first 60 bytes, the body and the arrays
};

using EnvelopeBytes = std::array<std::byte, envelope_size>;

/// The 64 bytes of `envelope`, checksum field included as given.
EnvelopeBytes encode(const Envelope& envelope);

/// The peer speaks another major version.
struct OtherVersion : ProtocolError {
  using ProtocolError::ProtocolError;
};

/// Throws ProtocolError for a wrong size or magic, OtherVersion for another major version.
Envelope decode_envelope(std::span<const std::byte> frame);

}  // namespace fissura
