// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/faults/relay.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "common/errors.hpp"
#include "common/exchange/codec.hpp"
#include "coupler/faults/forgery.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

constexpr Direction out = Direction::to_coupler;

Frames pressure(std::uint64_t sequence) {
  Message message(MessageType::pressure);
  message.interval = sequence + 10;
  message.revision = 2;
  message.body["ledger"] = {{"injected", 1.5}};
  message.add("pressure", "Pa", std::array{1e6, 2e6, 3e6});
  EncodedMessage encoded = encode(std::move(message), {RunId{7}, 1, sequence});
  Frames frames{{encoded.envelope.begin(), encoded.envelope.end()}};
  const auto body = std::as_bytes(std::span(encoded.body));
  frames.emplace_back(body.begin(), body.end());
  for (auto& array : encoded.arrays) frames.push_back(array);
  return frames;
}

DecodedMessage decoded(const Frames& frames) {
  std::vector<std::span<const std::byte>> views(frames.begin(), frames.end());
  return decode(views);
}

MessageFault at(std::uint64_t occurrence, MessageAction action) {
  MessageFault fault;
  fault.role = "network";
  fault.occurrence = occurrence;
  fault.action = action;
  return fault;
}

/// What arrives of four messages sent at once with this fault, by sequence number; -1: it cannot be read.
std::vector<int> arrivals(const MessageFault& fault, double later = 0) {
  Relay relay({fault}, [](Direction, const Frames&, const std::string&) {});
  std::vector<int> sequence;
  for (std::uint64_t i = 0; i < 4; ++i) relay.take(out, pressure(i), 0);
  while (const std::optional<Frames> message = relay.next(out, later)) {
    try {
      sequence.push_back(static_cast<int>(decoded(*message).stamp.sequence));
    } catch (const ProtocolError&) {
      sequence.push_back(-1);
    }
  }
  return sequence;
}

/// The second message after this fault.
Frames second(const MessageFault& fault) {
  Relay relay({fault}, [](Direction, const Frames&, const std::string&) {});
  for (std::uint64_t i = 0; i < 2; ++i) relay.take(out, pressure(i), 0);
  (void)relay.next(out, 0);
  return relay.next(out, 0).value();
}

}  // namespace

TEST_CASE("messages that no fault names pass as they are", "[coupler][faults]") {
  MessageFault other = at(1, MessageAction::drop);
  other.type = MessageType::response;
  CHECK(arrivals(other) == std::vector{0, 1, 2, 3});
  MessageFault elsewhere = at(1, MessageAction::drop);
  elsewhere.direction = Direction::to_participant;
  CHECK(arrivals(elsewhere) == std::vector{0, 1, 2, 3});
  MessageFault never = at(1, MessageAction::drop);
  never.interval = 99;
  CHECK(arrivals(never) == std::vector{0, 1, 2, 3});
  CHECK(second(never) == pressure(1));
}

TEST_CASE("a fault strikes the n-th message that fits, once", "[coupler][faults]") {
  CHECK(arrivals(at(2, MessageAction::drop)) == std::vector{0, 2, 3});
  MessageFault one = at(1, MessageAction::drop);
  one.interval = 12;
  CHECK(arrivals(one) == std::vector{0, 1, 3});
  CHECK(arrivals(at(2, MessageAction::duplicate)) == std::vector{0, 1, 1, 2, 3});
  CHECK(arrivals(at(2, MessageAction::swap)) == std::vector{0, 2, 1, 3});
  CHECK(arrivals(at(2, MessageAction::half_open)) == std::vector{0});
  CHECK(arrivals(at(2, MessageAction::cut)) == std::vector{0});
  CHECK(arrivals(at(3, MessageAction::replay)) == std::vector{0, 1, 1, 3});
  MessageFault nonsense = at(2, MessageAction::nonsense);
  nonsense.bytes = 10;
  CHECK(arrivals(nonsense) == std::vector{0, -1, 1, 2, 3});
}

TEST_CASE("what is held comes later and in order", "[coupler][faults]") {
  MessageFault late = at(2, MessageAction::delay);
  late.seconds = 3;
  CHECK(arrivals(late, 2.9) == std::vector{0});
  CHECK(arrivals(late, 3.1) == std::vector{0, 1, 2, 3});
  MessageFault slow = at(2, MessageAction::slow);
  slow.bytes_per_second = 1;
  const auto size =
      static_cast<double>(pressure(0)[0].size() + pressure(0)[1].size() + pressure(0)[2].size());
  CHECK(arrivals(slow, 1.5 * size) == std::vector{0, 1});
  CHECK(arrivals(slow, 3.5 * size) == std::vector{0, 1, 2, 3});
}

TEST_CASE("a clog holds both directions", "[coupler][faults]") {
  MessageFault clog = at(1, MessageAction::clog);
  clog.seconds = 3;
  Relay relay({clog}, [](Direction, const Frames&, const std::string&) {});
  relay.take(out, pressure(0), 0);
  relay.take(Direction::to_participant, pressure(0), 1);
  CHECK_FALSE(relay.next(Direction::to_participant, 2.9));
  CHECK(relay.next_time() == Approx(3));
  CHECK(relay.next(Direction::to_participant, 3.1));
  CHECK(relay.next(out, 3.1));
  CHECK_FALSE(relay.next_time());
}

TEST_CASE("damage on the way breaks the checksum or the frame", "[coupler][faults]") {
  const MessageFault flip = at(2, MessageAction::flip), truncate = at(2, MessageAction::truncate);
  CHECK(arrivals(flip) == std::vector{0, -1, 2, 3});
  CHECK(arrivals(truncate) == std::vector{0, -1, 2, 3});
  CHECK(second(truncate)[2].size() == pressure(1)[2].size() / 2);
  MessageFault header = truncate;
  header.frame = 0;
  header.bytes = 7;
  CHECK(second(header)[0].size() == 7);
}

TEST_CASE("forged messages carry a checksum that fits, so that only what they say is wrong",
          "[coupler][faults]") {
  MessageFault poison = at(2, MessageAction::poison);
  poison.field = "pressure";
  poison.index = 1;
  poison.value = -5;
  CHECK(decoded(second(poison)).message.numbers("pressure") == std::vector{1e6, -5.0, 3e6});
  MessageFault entry = at(2, MessageAction::poison);
  entry.entry = "/ledger/injected";
  entry.value = 9;
  CHECK(decoded(second(entry)).message.body["ledger"]["injected"] == 9);
  MessageFault resize = at(2, MessageAction::resize);
  resize.field = "pressure";
  resize.length = 4;
  CHECK(decoded(second(resize)).message.numbers("pressure") == std::vector{1e6, 2e6, 3e6, 0.0});
  MessageFault relabel = at(2, MessageAction::relabel);
  relabel.field = "pressure";
  relabel.unit = "MPa";
  CHECK(decoded(second(relabel)).message.arrays.at(0).unit == "MPa");
  MessageFault oversize = at(2, MessageAction::oversize);
  oversize.bytes = 1000;
  CHECK(second(oversize)[2].size() == 1000);
  CHECK_THROWS_WITH(decoded(second(oversize)), Catch::Contains("another size"));
}

TEST_CASE("every field of the envelope can be forged", "[coupler][faults]") {
  const auto forged = [](StampField stamp, std::optional<std::uint64_t> value, std::int64_t shift) {
    MessageFault fault = at(2, MessageAction::restamp);
    fault.stamp = stamp;
    fault.stamp_value = value;
    fault.shift = shift;
    return decoded(second(fault));
  };
  CHECK(forged(StampField::sequence, std::nullopt, -1).stamp.sequence == 0);
  CHECK(forged(StampField::sequence, 40, 0).stamp.sequence == 40);
  CHECK(forged(StampField::epoch, std::nullopt, 1).stamp.epoch == 2);
  CHECK(forged(StampField::run, 9, 0).stamp.run[3] == 9);
  CHECK(forged(StampField::interval, std::nullopt, -1).message.interval == 10);
  CHECK(forged(StampField::revision, 5, 0).message.revision == 5);
  CHECK(forged(StampField::type, 22, 0).message.type == MessageType::response);
  CHECK(forged(StampField::minor, 3, 0).message.interval == 11);
  CHECK_THROWS_WITH(forged(StampField::major, 9, 0), Catch::Contains("peer speaks protocol 9."));
}

TEST_CASE("an old message comes as it was, or as if it were the current one", "[coupler][faults]") {
  MessageFault replay = at(2, MessageAction::replay);
  CHECK(second(replay) == pressure(0));
  replay.as = ReplayAs::current;
  const DecodedMessage stale = decoded(second(replay));
  CHECK(stale.stamp.sequence == 1);
  CHECK(stale.message.interval == 10);
}

TEST_CASE("what was done is noted with the message as it came", "[coupler][faults]") {
  std::vector<std::string> notes;
  MessageFault missing = at(2, MessageAction::poison);
  missing.field = "temperature";
  Relay relay({at(1, MessageAction::drop), missing},
              [&](Direction, const Frames& message, const std::string& did) {
                CHECK_NOTHROW(decoded(message));
                notes.push_back(did);
              });
  for (std::uint64_t i = 0; i < 3; ++i) relay.take(out, pressure(i), 0);
  CHECK(notes == std::vector<std::string>{"drop", "poison: the message has no such thing", ""});
}
