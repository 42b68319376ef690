// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/envelope.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "common/errors.hpp"

namespace fissura {

namespace {

static_assert(std::endian::native == std::endian::little, "the wire format is little-endian");

constexpr std::array<char, 4> magic{'F', 'I', 'S', '1'};

// One field after the other, in the order of docs/protocol.md; Place is put<T> or take<T>.
template <typename EnvelopeType, typename Place>
void for_each_field(EnvelopeType& envelope, Place place) {
  place(envelope.major);
  place(envelope.minor);
  place(envelope.type);
  place(envelope.run);
  place(envelope.epoch);
  place(envelope.array_count);
  place(envelope.sequence);
  place(envelope.interval);
  place(envelope.revision);
  place(envelope.body_length);
  place(envelope.checksum);
}

}  // namespace

EnvelopeBytes encode(const Envelope& envelope) {
  EnvelopeBytes bytes{};
  std::memcpy(bytes.data(), magic.data(), magic.size());
  std::size_t offset = magic.size();
  for_each_field(envelope, [&](const auto& field) {
    std::memcpy(bytes.data() + offset, &field, sizeof(field));
    offset += sizeof(field);
  });
  ENSURE(offset == envelope_size);
  return bytes;
}

Envelope decode_envelope(std::span<const std::byte> frame) {
  if (frame.size() != envelope_size)
    throw ProtocolError(fmt::format("envelope must have {} bytes, found {}", envelope_size, frame.size()));
  if (std::memcmp(frame.data(), magic.data(), magic.size()) != 0)
    throw ProtocolError("envelope does not begin with FIS1");
  Envelope envelope;
  std::size_t offset = magic.size();
  for_each_field(envelope, [&](auto& field) {
    std::memcpy(&field, frame.data() + offset, sizeof(field));
    offset += sizeof(field);
  });
  if (envelope.major != protocol_major)
    throw OtherVersion(fmt::format("peer speaks protocol {}.{}, this program speaks {}.{}", envelope.major,
                                   envelope.minor, protocol_major, protocol_minor));
  return envelope;
}

}  // namespace fissura
