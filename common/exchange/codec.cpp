// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/codec.hpp"

#include <fmt/format.h>

#include "common/errors.hpp"
#include "common/exact_json.hpp"
#include "common/hash.hpp"

namespace fissura {

namespace {

constexpr std::size_t checked_envelope_bytes = envelope_size - sizeof(Envelope::checksum);

std::size_t item_size(std::string_view dtype) {
  if (dtype == "float64" || dtype == "int64" || dtype == "uint64") return 8;
  if (dtype == "uint8") return 1;
  throw ProtocolError(fmt::format("array type must be float64, int64, uint64 or uint8, found {}", dtype));
}

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

Array declared_array(const nlohmann::json& declaration, std::span<const std::byte> frame) {
  Array array;
  declaration.at("name").get_to(array.name);
  declaration.at("dtype").get_to(array.dtype);
  array.shape = exactly<std::vector<std::uint64_t>>(declaration.at("shape"));
  declaration.at("unit").get_to(array.unit);
  std::size_t expected = item_size(array.dtype);
  for (const std::uint64_t extent : array.shape) {
    if (extent != 0 && expected > frame.size() / extent) {
      expected = frame.size() + 1;
      break;
    }
    expected *= extent;
  }
  if (expected != frame.size())
    throw ProtocolError(fmt::format("array {} declares another size than its {} bytes", array.name, frame.size()));
  array.bytes.assign(frame.begin(), frame.end());
  return array;
}

}  // namespace

EncodedMessage encode(Message message, const Stamp& stamp) {
  EncodedMessage encoded;
  if (!message.arrays.empty()) {
    nlohmann::json declarations = nlohmann::json::array();
    for (const Array& array : message.arrays)
      declarations.push_back(
          {{"name", array.name}, {"dtype", array.dtype}, {"shape", array.shape}, {"unit", array.unit}});
    message.body["arrays"] = std::move(declarations);
  }
  encoded.body = message.body.dump();
  for (Array& array : message.arrays) encoded.arrays.push_back(std::move(array.bytes));

  Envelope envelope;
  envelope.type = message.type;
  envelope.run = stamp.run;
  envelope.epoch = stamp.epoch;
  envelope.array_count = static_cast<std::uint32_t>(encoded.arrays.size());
  envelope.sequence = stamp.sequence;
  envelope.interval = message.interval;
  envelope.revision = message.revision;
  envelope.body_length = static_cast<std::uint32_t>(encoded.body.size());
  encoded.envelope = encode(envelope);

  std::uint32_t sum = crc32(std::span(encoded.envelope).first(checked_envelope_bytes));
  sum = crc32(bytes_of(encoded.body), sum);
  for (const auto& array : encoded.arrays) sum = crc32(array, sum);
  envelope.checksum = sum;
  encoded.envelope = encode(envelope);
  return encoded;
}

std::vector<std::span<const std::byte>> frames_of(const EncodedMessage& encoded) {
  std::vector<std::span<const std::byte>> frames{encoded.envelope, bytes_of(encoded.body)};
  frames.insert(frames.end(), encoded.arrays.begin(), encoded.arrays.end());
  return frames;
}

DecodedMessage decode(std::span<const std::span<const std::byte>> frames) {
  if (frames.size() < 2)
    throw ProtocolError(fmt::format("a message has at least 2 frames, found {}", frames.size()));
  const Envelope envelope = decode_envelope(frames[0]);
  const std::string label = name(envelope.type);
  if (envelope.array_count != frames.size() - 2)
    throw ProtocolError(fmt::format("{} announces {} arrays, found {}", label, envelope.array_count, frames.size() - 2));
  if (envelope.body_length != frames[1].size())
    throw ProtocolError(
        fmt::format("{} announces a body of {} bytes, found {}", label, envelope.body_length, frames[1].size()));
  std::uint32_t sum = crc32(frames[0].first(checked_envelope_bytes));
  for (const auto frame : frames.subspan(1)) sum = crc32(frame, sum);
  if (sum != envelope.checksum) throw ProtocolError(label + " is damaged: its checksum does not fit");
  if (label == "UNKNOWN")
    throw ProtocolError(fmt::format("unknown message type {}", static_cast<int>(envelope.type)));

  DecodedMessage decoded;
  decoded.stamp = {envelope.run, envelope.epoch, envelope.sequence};
  Message& message = decoded.message;
  message.type = envelope.type;
  message.interval = envelope.interval;
  message.revision = envelope.revision;
  try {
    const auto* text = reinterpret_cast<const char*>(frames[1].data());
    message.body = nlohmann::json::parse(text, text + frames[1].size());
    const nlohmann::json declarations = message.body.value("arrays", nlohmann::json::array());
    if (declarations.size() != envelope.array_count)
      throw ProtocolError(fmt::format("{} declares {} arrays in its body, found {}", label, declarations.size(),
                                      envelope.array_count));
    for (std::size_t i = 0; i < declarations.size(); ++i)
      message.arrays.push_back(declared_array(declarations[i], frames[i + 2]));
  } catch (const nlohmann::json::exception& fault) {
    throw ProtocolError(fmt::format("{} has an unreadable body: {}", label, fault.what()));
  }
  return decoded;
}

}  // namespace fissura
