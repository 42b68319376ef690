// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "common/errors.hpp"
#include "common/exchange/array_units.hpp"
#include "common/exchange/codec.hpp"
#include "common/seismicity/source_record.hpp"

using namespace fissura;

namespace {

Message sample() {
  Message message(MessageType::pressure);
  message.interval = 7;
  message.revision = 3;
  message.body = {{"well_pressure", 6.5e6}};
  message.add("pressure", "Pa", std::vector<double>{1.0, -0.0, 5e-324, 1.7976931348623157e308});
  message.add_ids("elements", std::vector<std::uint64_t>{0, 1, 2, 3, 4, 5}, 3);
  return message;
}

Stamp sample_stamp() {
  Stamp stamp;
  stamp.run.fill(0xab);
  stamp.epoch = 2;
  stamp.sequence = 41;
  return stamp;
}

std::vector<std::vector<std::byte>> copied_frames(const EncodedMessage& encoded) {
  std::vector<std::vector<std::byte>> frames;
  for (const auto& frame : frames_of(encoded)) frames.emplace_back(frame.begin(), frame.end());
  return frames;
}

DecodedMessage decode_all(const std::vector<std::vector<std::byte>>& frames) {
  std::vector<std::span<const std::byte>> views(frames.begin(), frames.end());
  return decode(views);
}

}  // namespace

TEST_CASE("a message comes out of the codec as it went in, bit for bit", "[common][exchange]") {
  const DecodedMessage decoded = decode_all(copied_frames(encode(sample(), sample_stamp())));
  CHECK(decoded.stamp.sequence == 41);
  CHECK(decoded.stamp.epoch == 2);
  CHECK(decoded.stamp.run == sample_stamp().run);
  CHECK(decoded.message.type == MessageType::pressure);
  CHECK(decoded.message.interval == 7);
  CHECK(decoded.message.revision == 3);
  CHECK(decoded.message.value<double>("well_pressure") == 6.5e6);
  const std::vector<double> pressure = decoded.message.numbers("pressure", 4);
  CHECK(pressure == sample().numbers("pressure"));
  CHECK(std::signbit(pressure[1]));
  CHECK(decoded.message.arrays[1].shape == std::vector<std::uint64_t>{2, 3});
  CHECK(decoded.message.ids("elements").back() == 5);
}

TEST_CASE("the envelope has the layout of docs/protocol.md", "[common][exchange]") {
  const EncodedMessage encoded = encode(sample(), sample_stamp());
  const auto* bytes = reinterpret_cast<const unsigned char*>(encoded.envelope.data());
  CHECK(std::string(bytes, bytes + 4) == "FIS1");
  CHECK(bytes[4] == 1);
  CHECK(bytes[6] == 21);
  CHECK(bytes[8] == 0xab);
  CHECK(bytes[24] == 2);
  CHECK(bytes[28] == 2);
  CHECK(bytes[32] == 41);
  CHECK(bytes[40] == 7);
  CHECK(bytes[48] == 3);
  CHECK(bytes[56] == encoded.body.size() % 256);
}

TEST_CASE("a flipped bit anywhere in a message is noticed", "[common][exchange]") {
  const auto frames = copied_frames(encode(sample(), sample_stamp()));
  for (std::size_t frame = 0; frame < frames.size(); ++frame)
    for (std::size_t byte = 0; byte < frames[frame].size(); ++byte) {
      auto damaged = frames;
      damaged[frame][byte] ^= std::byte{0x10};
      INFO("frame " << frame << ", byte " << byte);
      CHECK_THROWS_AS(decode_all(damaged), ProtocolError);
    }
}

TEST_CASE("missing, additional, cut and empty frames are noticed", "[common][exchange]") {
  const auto frames = copied_frames(encode(sample(), sample_stamp()));
  auto missing = frames;
  missing.pop_back();
  CHECK_THROWS_AS(decode_all(missing), ProtocolError);
  auto additional = frames;
  additional.push_back(frames.back());
  CHECK_THROWS_AS(decode_all(additional), ProtocolError);
  auto cut = frames;
  cut.back().pop_back();
  CHECK_THROWS_AS(decode_all(cut), ProtocolError);
  CHECK_THROWS_AS(decode_all({}), ProtocolError);
  CHECK_THROWS_AS(decode_all({{}, {}}), ProtocolError);
}

TEST_CASE("another major version is refused, another minor one is not", "[common][exchange]") {
  Envelope envelope;
  envelope.minor = 9;
  CHECK(decode_envelope(encode(envelope)).minor == 9);
  envelope.major = 2;
  CHECK_THROWS_WITH(decode_envelope(encode(envelope)), Catch::Contains("peer speaks protocol 2.9"));
}

TEST_CASE("a value that is not finite is refused with its place", "[common][exchange]") {
  Message message(MessageType::pressure);
  message.interval = 12;
  message.add("pressure", "Pa", std::vector<double>{1, std::numeric_limits<double>::quiet_NaN()});
  CHECK_THROWS_WITH(message.numbers("pressure"), Catch::Contains("PRESSURE interval 12: pressure[1] is nan"));
  CHECK_THROWS_AS(message.numbers("pressure"), ValueError);
}

TEST_CASE("an array of another name, type or length is refused", "[common][exchange]") {
  const Message message = sample();
  CHECK_THROWS_WITH(message.numbers("aperture"), Catch::Contains("array aperture is missing"));
  CHECK_THROWS_WITH(message.numbers("elements"), Catch::Contains("must be float64, found uint64"));
  CHECK_THROWS_WITH(message.numbers("pressure", 5), Catch::Contains("has 4 values, expected 5"));
  CHECK_THROWS_WITH(message.value<std::string>("well_pressure"), Catch::Contains("well_pressure"));
}

TEST_CASE(
    "an array in another unit than the protocol gives its name is told of with field, expected and found",
    "[common][exchange]") {
  Message message(MessageType::pressure);
  message.interval = 7;
  message.add("pressure", "Pa", std::vector<double>{1e6});
  message.add("temperature", "K", std::vector<double>{300});
  message.add_bytes("state", {});
  CHECK_FALSE(wrong_unit(message));
  message.add("filled", "%", std::vector<double>{100});
  CHECK(wrong_unit(message) == "PRESSURE interval 7: filled must be in \"1\", found \"%\"");
  message.arrays[0].unit = "MPa";
  CHECK(wrong_unit(message) == "PRESSURE interval 7: pressure must be in \"Pa\", found \"MPa\"");
}

TEST_CASE("records of seismic sources have the units of the protocol", "[common][exchange]") {
  Message message(MessageType::response);
  message.arrays = arrays_of({SourceRecord{}});
  REQUIRE_FALSE(message.arrays.empty());
  for (const Array& array : message.arrays) {
    INFO(array.name);
    CHECK(unit_of_array(array.name) == array.unit);
  }
}

TEST_CASE("arrays of a network without nodes survive the way", "[common][exchange]") {
  Message message(MessageType::topology);
  message.add("aperture", "m", std::vector<double>{});
  message.add("closed", "1", std::vector<double>{});
  auto frames = copied_frames(encode(message, sample_stamp()));
  for (auto& frame : frames) frame.reserve(1);  // a frame from a socket has an address even when it is empty
  const Message received = decode_all(frames).message;
  CHECK(received.numbers("aperture", 0).empty());
}
