// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/faults/forgery.hpp"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "common/exchange/envelope.hpp"
#include "common/hash.hpp"

namespace fissura::coupler {

namespace {

constexpr std::size_t frames_before_arrays = 2;
constexpr std::size_t checked_envelope_bytes = envelope_size - sizeof(Envelope::checksum);

/// Envelope and body of a message, and after a change the frames that belong to them, with a checksum that
/// fits.
class OpenedMessage {
 public:
  explicit OpenedMessage(Frames& frames) : frames_(frames) {
    if (frames.size() < frames_before_arrays) return;
    try {
      envelope = decode_envelope(frames[0]);
      const auto* text = reinterpret_cast<const char*>(frames[1].data());
      body = nlohmann::json::parse(text, text + frames[1].size());
      readable_ = true;
    } catch (const ProtocolError&) {
    } catch (const nlohmann::json::exception&) {
    }
  }

  [[nodiscard]] bool readable() const { return readable_; }

  /// The declaration of an array, and its frame.
  std::pair<nlohmann::json*, std::vector<std::byte>*> find(const std::string& field) {
    if (!readable_ || !body.contains("arrays")) return {};
    nlohmann::json& declarations = body["arrays"];
    for (std::size_t i = 0; i < declarations.size() && i + frames_before_arrays < frames_.size(); ++i)
      if (declarations[i].value("name", "") == field)
        return {&declarations[i], &frames_[i + frames_before_arrays]};
    return {};
  }

  void write_body() {
    const std::string text = body.dump();
    const auto bytes = std::as_bytes(std::span(text));
    frames_[1].assign(bytes.begin(), bytes.end());
    envelope.body_length = static_cast<std::uint32_t>(text.size());
  }

  void close() {
    const auto put = [this] {
      const EnvelopeBytes bytes = encode(envelope);
      frames_[0].assign(bytes.begin(), bytes.end());
    };
    put();
    std::uint32_t sum = crc32(std::span(frames_[0]).first(checked_envelope_bytes));
    for (std::size_t i = 1; i < frames_.size(); ++i) sum = crc32(frames_[i], sum);
    envelope.checksum = sum;
    put();
  }

  Envelope envelope;
  nlohmann::json body;

 private:
  Frames& frames_;
  bool readable_ = false;
};

std::vector<std::byte>* frame_at(Frames& message, std::optional<std::uint64_t> frame) {
  const std::uint64_t index = frame.value_or(message.size() - 1);
  return index < message.size() && !message[index].empty() ? &message[index] : nullptr;
}

template <typename T>
void change(T& field, std::optional<std::uint64_t> value, std::int64_t shift) {
  field =
      static_cast<T>(value.value_or(static_cast<std::uint64_t>(field) + static_cast<std::uint64_t>(shift)));
}

}  // namespace

bool truncate(Frames& message, std::optional<std::uint64_t> frame, std::optional<std::uint64_t> bytes) {
  std::vector<std::byte>* place = frame_at(message, frame);
  if (place == nullptr) return false;
  const std::uint64_t kept = bytes.value_or(place->size() / 2);
  if (kept >= place->size()) return false;
  place->resize(kept);
  return true;
}

bool flip(Frames& message, std::optional<std::uint64_t> frame, std::uint64_t bit) {
  std::vector<std::byte>* place = frame_at(message, frame);
  if (place == nullptr) return false;
  constexpr std::uint64_t bits = 8;
  (*place)[bit / bits % place->size()] ^= std::byte(1U << (bit % bits));
  return true;
}

bool resize(Frames& message, const std::string& field, std::uint64_t length) {
  OpenedMessage opened(message);
  const auto [declaration, frame] = opened.find(field);
  if (frame == nullptr) return false;
  const std::size_t item = declaration->value("dtype", "") == "uint8" ? 1 : sizeof(double);
  frame->resize(length * item);
  (*declaration)["shape"] = {length};
  opened.write_body();
  opened.close();
  return true;
}

bool restamp(Frames& message, StampField stamp, std::optional<std::uint64_t> value, std::int64_t shift) {
  OpenedMessage opened(message);
  if (!opened.readable()) return false;
  Envelope& envelope = opened.envelope;
  switch (stamp) {
    case StampField::major:
      change(envelope.major, value, shift);
      break;
    case StampField::minor:
      change(envelope.minor, value, shift);
      break;
    case StampField::type:
      change(envelope.type, value, shift);
      break;
    case StampField::run:
      for (std::uint8_t& byte : envelope.run) change(byte, value, shift);
      break;
    case StampField::epoch:
      change(envelope.epoch, value, shift);
      break;
    case StampField::sequence:
      change(envelope.sequence, value, shift);
      break;
    case StampField::interval:
      change(envelope.interval, value, shift);
      break;
    case StampField::revision:
      change(envelope.revision, value, shift);
      break;
  }
  opened.close();
  return true;
}

bool poison(Frames& message, const std::string& field, std::uint64_t index, double value) {
  OpenedMessage opened(message);
  const auto [declaration, frame] = opened.find(field);
  if (frame == nullptr || declaration->value("dtype", "") != "float64") return false;
  if (index >= frame->size() / sizeof(value)) return false;
  std::memcpy(frame->data() + index * sizeof(value), &value, sizeof(value));
  opened.close();
  return true;
}

bool poison(Frames& message, const std::string& entry, double value) {
  OpenedMessage opened(message);
  if (!opened.readable()) return false;
  const nlohmann::json::json_pointer place(entry);
  if (!opened.body.contains(place)) return false;
  opened.body[place] = value;
  opened.write_body();
  opened.close();
  return true;
}

bool relabel(Frames& message, const std::string& field, const std::string& unit) {
  OpenedMessage opened(message);
  const auto [declaration, frame] = opened.find(field);
  if (frame == nullptr) return false;
  (*declaration)["unit"] = unit;
  opened.write_body();
  opened.close();
  return true;
}

bool oversize(Frames& message, std::uint64_t bytes) {
  OpenedMessage opened(message);
  if (!opened.readable() || bytes <= message.back().size()) return false;
  message.back().resize(bytes);
  opened.envelope.body_length = static_cast<std::uint32_t>(message[1].size());
  opened.close();
  return true;
}

Frames nonsense(std::uint64_t bytes) {
  constexpr std::uint64_t factor = 131, offset = 7;
  std::vector<std::byte> frame(bytes);
  for (std::uint64_t i = 0; i < bytes; ++i) frame[i] = static_cast<std::byte>(i * factor + offset);
  return {frame};
}

}  // namespace fissura::coupler
