// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/raw_frames.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "common/hash.hpp"

namespace fissura::fuzz {

namespace {

constexpr std::string_view magic = "FIS1";
constexpr std::size_t major_at = 4, array_count_at = 28, body_length_at = 56, checksum_at = 60;

void put(std::vector<std::byte>& envelope, std::size_t at, std::uint32_t value) {
  std::memcpy(envelope.data() + at, &value, sizeof(value));
}

}  // namespace

Frames frames_of(std::span<const std::byte> bytes) {
  Frames frames;
  std::uint16_t length = 0;
  while (bytes.size() >= sizeof(length)) {
    std::memcpy(&length, bytes.data(), sizeof(length));
    bytes = bytes.subspan(sizeof(length));
    const auto frame = bytes.first(std::min<std::size_t>(length, bytes.size()));
    frames.emplace_back(frame.begin(), frame.end());
    bytes = bytes.subspan(frame.size());
  }
  return frames;
}

std::vector<std::byte> bytes_of(const Frames& frames) {
  std::vector<std::byte> bytes;
  for (const auto& frame : frames) {
    const auto length = static_cast<std::uint16_t>(frame.size());
    const auto* first = reinterpret_cast<const std::byte*>(&length);
    bytes.insert(bytes.end(), first, first + sizeof(length));
    bytes.insert(bytes.end(), frame.begin(), frame.end());
  }
  return bytes;
}

Frames frames_of(EncodedMessage encoded) {
  Frames frames{{encoded.envelope.begin(), encoded.envelope.end()}};
  const auto* body = reinterpret_cast<const std::byte*>(encoded.body.data());
  frames.emplace_back(body, body + encoded.body.size());
  for (auto& array : encoded.arrays) frames.push_back(std::move(array));
  return frames;
}

Frames restamped(Frames frames) {
  if (frames.size() < 2) return frames;
  std::vector<std::byte>& envelope = frames[0];
  envelope.resize(envelope_size);
  std::memcpy(envelope.data(), magic.data(), magic.size());
  envelope[major_at] = std::byte{protocol_major};
  put(envelope, array_count_at, static_cast<std::uint32_t>(frames.size() - 2));
  put(envelope, body_length_at, static_cast<std::uint32_t>(frames[1].size()));
  std::uint32_t sum = crc32(std::span(std::as_const(envelope)).first(checksum_at));
  for (std::size_t i = 1; i < frames.size(); ++i) sum = crc32(frames[i], sum);
  put(envelope, checksum_at, sum);
  return frames;
}

DecodedMessage decode(const Frames& frames) {
  std::vector<std::span<const std::byte>> views(frames.begin(), frames.end());
  return fissura::decode(views);
}

}  // namespace fissura::fuzz
